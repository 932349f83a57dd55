#pragma once

#include <QAbstractItemModel>
#include <QString>

namespace gorizont::test {

/// The model as it is read on the screen: one line a row, cells divided by ` | `, children indented by two blanks.
/// \a withHeader: the headings first.
QString modelText(const QAbstractItemModel &model, bool withHeader = false);

} // namespace gorizont::test
