#pragma once

#include "core/export/exportrequest.h"

#include <variant>

class QCommandLineParser;

namespace gorizont::tool {

/// What the command line cannot know of a site.
struct ExportSite
{
    QList<SensorConfig> sensors;
    QString name; ///< of the site: what miniSEED calls the station, unless --station does
    QTimeZone zone; ///< of times without one; invalid: that of the computer
};

/// Tells a \a parser of its own what `gorizont-tool export` takes: it shares no line and no address with the others.
void describeExport(QCommandLineParser &parser);

/// What the options of a parsed command line ask for, or what is wrong with them, as a sentence.
std::variant<ExportRequest, QString> exportRequest(const QCommandLineParser &parser, const ExportSite &site);

} // namespace gorizont::tool
