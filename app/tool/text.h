#pragma once

#include <QCoreApplication>

namespace gorizont::tool {

/// The sentences of gorizont-tool.
class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::tool::Text)
};

} // namespace gorizont::tool
