#include "app/tool/command.h"

#include "app/tool/and3commands.h"
#include "app/tool/ind3commands.h"
#include "app/tool/text.h"
#include "app/tool/usmcommands.h"

#include <algorithm>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

const QList<Command> &commands()
{
    static const QList<Command> table{
        {.name = u"scan"_s,
         .options = {u"from"_s, u"to"_s},
         .needsAddress = false,
         .runInd3 = ind3commands::scan,
         .runAnd3 = and3commands::scan,
         .description = Text::tr("looks for sensors at the addresses 1…255")},
        {.name = u"read"_s,
         .options = {u"count"_s, u"interval"_s},
         .runInd3 = ind3commands::read,
         .runAnd3 = and3commands::read,
         .description = Text::tr("prints what the sensor measures")},
        {.name = u"info"_s,
         .runInd3 = ind3commands::info,
         .runAnd3 = and3commands::info,
         .description = Text::tr("prints what the sensor is and its settings")},
        {.name = u"set-address"_s,
         .arguments = u"NEW"_s,
         .writes = true,
         .runInd3 = ind3commands::setAddress,
         .runAnd3 = and3commands::setAddress,
         .description = Text::tr("gives the sensor another address; an АН-Д3 is restarted")},
        {.name = u"set-name"_s,
         .arguments = u"TEXT"_s,
         .writes = true,
         .runInd3 = ind3commands::setName,
         .description = Text::tr("writes the name, at most 16 characters; not in Modbus")},
        {.name = u"set-offset"_s,
         .arguments = u"X Y"_s,
         .writes = true,
         .runInd3 = ind3commands::setOffset,
         .description = Text::tr("writes the zero offset, arc-seconds")},
        {.name = u"set-averaging"_s,
         .options = {u"ticks"_s, u"period"_s},
         .writes = true,
         .runInd3 = ind3commands::setAveraging,
         .description = Text::tr("writes the averaging: --ticks, --period or both")},
        {.name = u"reset"_s,
         .writes = true,
         .runAnd3 = and3commands::reset,
         .description = Text::tr("restarts the controller of an АН-Д3, about 5 s")},
    };
    static const QList<Command> all = table + usmcommands::table();
    return all;
}

const Command *commandNamed(const QString &name)
{
    const auto found = std::find_if(commands().begin(), commands().end(), [&name](const Command &command) {
        return command.name == name;
    });
    return found == commands().end() ? nullptr : &*found;
}

} // namespace gorizont::tool
