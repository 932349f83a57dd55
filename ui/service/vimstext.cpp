#include "ui/service/vimstext.h"

#include <QCoreApplication>

#include <algorithm>

namespace gorizont::vimstext {

namespace {

class VimsText
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::VimsText)
};

constexpr qsizetype mostLines = 12; ///< of a question

} // namespace

QString mode(int mode)
{
    switch (mode) {
    case lvims::bootLoaderMode: return VimsText::tr("%1, boot loader: it measures nothing").arg(mode);
    case lvims::workingMode: return VimsText::tr("%1, at work").arg(mode);
    default: break;
    }
    return QString::number(mode);
}

QString error(quint32 code)
{
    return code == 0 ? VimsText::tr("0, none")
                     : QStringLiteral("%1 (%2h)").arg(code).arg(QString::number(code, 16).toUpper());
}

QString errors(const lvims::SettingErrors &errors)
{
    return QStringLiteral("LAST_WR_ERROR %1, LAST_CHECK_SETTINGS_ERR %2").arg(errors.first).arg(errors.second);
}

QString differences(const QList<lvims::SettingDifference> &differences)
{
    QStringList lines;
    for (const lvims::SettingDifference &difference : differences.first(std::min(differences.size(), mostLines))) {
        lines += QStringLiteral("%1: %2 → %3").arg(difference.name, difference.before, difference.after);
    }
    if (const auto more = static_cast<int>(differences.size() - mostLines); more > 0) {
        lines += VimsText::tr("and %n more", nullptr, more);
    }
    return lines.join(u'\n');
}

bool touchesNetwork(const QList<lvims::SettingDifference> &differences)
{
    return std::any_of(differences.begin(), differences.end(), [](const lvims::SettingDifference &difference) {
        return difference.isOfNetwork;
    });
}

QString networkWarning(const QList<quint16> &wanted, int port)
{
    const QString address = lvims::valueOf(wanted, *lvims::settingNamed(QStringLiteral("IP_ADDR")));
    return VimsText::tr("The network settings change: the connection to the module will be lost. Write the new address "
                        "%1 into Device of [Port%2] in the configuration file and start the program again.")
        .arg(address)
        .arg(port);
}

} // namespace gorizont::vimstext
