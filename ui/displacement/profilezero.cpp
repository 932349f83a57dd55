#include "ui/displacement/profilezero.h"

#include <QDateTime>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

#include <algorithm>
#include <cmath>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

std::optional<ProfileZero> ProfileZero::of(const std::vector<ChainNode> &nodes, UtcTime time)
{
    ProfileZero zero{time, {}};
    for (const ChainNode &node : nodes) {
        if (!node.sum) {
            return {};
        }
        zero.nodes.append(Node{node.number, node.height, *node.sum});
    }
    return zero;
}

std::optional<Displacement> ProfileZero::at(const ChainNode &place) const
{
    constexpr double same = 0.001; // m
    const auto node = std::find_if(nodes.begin(), nodes.end(), [&place](const Node &one) {
        return one.number == place.number && std::abs(one.height.value_or(place.height) - place.height) < same;
    });
    return node != nodes.end() ? std::optional(node->sum) : std::nullopt;
}

QByteArray ProfileZero::toJson() const
{
    QJsonArray list;
    for (const Node &node : nodes) {
        QJsonObject entry{{u"number"_s, node.number}, {u"x"_s, node.sum.x}, {u"y"_s, node.sum.y}};
        if (node.height) {
            entry.insert(u"height"_s, *node.height);
        }
        list.append(entry);
    }
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count();
    const QString moment = QDateTime::fromMSecsSinceEpoch(ms, Qt::UTC).toString(Qt::ISODateWithMs);
    return QJsonDocument(QJsonObject{{u"time"_s, moment}, {u"nodes"_s, list}}).toJson();
}

std::optional<ProfileZero> ProfileZero::fromJson(const QByteArray &json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    const QDateTime moment = QDateTime::fromString(object.value(u"time").toString(), Qt::ISODateWithMs);
    const QJsonArray list = object.value(u"nodes").toArray();
    if (!moment.isValid() || list.isEmpty()) {
        return {};
    }
    ProfileZero zero{UtcTime(std::chrono::milliseconds(moment.toMSecsSinceEpoch())), {}};
    for (const auto &entry : list) {
        const QJsonObject node = entry.toObject();
        if (!node.value(u"number").isDouble() || !node.value(u"x").isDouble() || !node.value(u"y").isDouble()) {
            return {};
        }
        const Displacement sum{node.value(u"x").toDouble(), node.value(u"y").toDouble()};
        const QJsonValue height = node.value(u"height");
        zero.nodes.append(
            {node.value(u"number").toInt(), height.isDouble() ? std::optional(height.toDouble()) : std::nullopt, sum});
    }
    return zero;
}

QString ProfileZeroFiles::path(int chain) const
{
    return QDir(m_folder).filePath(u"chain%1.json"_s.arg(chain));
}

std::optional<ProfileZero> ProfileZeroFiles::load(int chain) const
{
    constexpr qint64 longest = 1024 * 1024;
    QFile file(path(chain));
    return file.open(QIODevice::ReadOnly) ? ProfileZero::fromJson(file.read(longest)) : std::nullopt;
}

bool ProfileZeroFiles::save(int chain, const ProfileZero &zero)
{
    const QByteArray json = zero.toJson();
    QDir().mkpath(m_folder);
    QSaveFile file(path(chain));
    if (file.open(QIODevice::WriteOnly) && file.write(json) == json.size() && file.commit()) {
        return true;
    }
    m_error = QDir::toNativeSeparators(file.fileName()) + u": "_s + file.errorString();
    return false;
}

bool ProfileZeroFiles::remove(int chain)
{
    QFile file(path(chain));
    if (!file.exists() || file.remove()) {
        return true;
    }
    m_error = QDir::toNativeSeparators(file.fileName()) + u": "_s + file.errorString();
    return false;
}

} // namespace gorizont
