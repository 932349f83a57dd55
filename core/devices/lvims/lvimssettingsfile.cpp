#include "core/devices/lvims/lvimssettingsfile.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace gorizont::lvims {

using Qt::Literals::StringLiterals::operator""_s;

void insertIdentity(QJsonObject &object, const Identity &identity)
{
    object.insert(u"name"_s, identity.name);
    object.insert(u"serial"_s, identity.serial);
    object.insert(u"firmware"_s, identity.firmware);
    object.insert(u"board"_s, identity.board);
    object.insert(u"mode"_s, identity.mode);
    insertErrors(object, {identity.writeError, identity.settingsError});
}

void insertErrors(QJsonObject &object, const SettingErrors &errors)
{
    object.insert(u"writeError"_s, errors.first);
    object.insert(u"settingsError"_s, qint64(errors.second));
}

QByteArray settingsFile(const Identity &identity, const QList<quint16> &image)
{
    QJsonObject object{{u"type"_s, u"L-VIMS"_s}};
    insertIdentity(object, identity);
    QJsonArray registers;
    for (const quint16 value : image) {
        registers.append(value);
    }
    object.insert(u"registers"_s, registers);
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

std::optional<QList<quint16>> settingsIn(const QByteArray &bytes)
{
    const QJsonObject object = QJsonDocument::fromJson(bytes).object();
    const QJsonArray registers = object.value(u"registers"_s).toArray();
    if (object.value(u"type"_s).toString() != u"L-VIMS" || registers.size() != settingsSize) {
        return std::nullopt;
    }
    QList<quint16> image;
    image.reserve(registers.size());
    for (const QJsonValue &value : registers) {
        const int number = value.toInt(-1);
        if (number < 0 || number > 65535) {
            return std::nullopt;
        }
        image.append(static_cast<quint16>(number));
    }
    return image;
}

} // namespace gorizont::lvims
