#pragma once

#include "core/values/displacement.h"

#include <QByteArray>

namespace gorizont {

/// The shape of a chain at a moment that somebody chose to compare with.
struct ProfileZero
{
    struct Node
    {
        int number = 0; ///< N, the sensor
        std::optional<double> height; ///< m above the foot of the chain; empty: a file of an older program
        Displacement sum; ///< over the foot of the chain
        bool operator==(const Node &) const = default;
    };

    UtcTime time;
    QList<Node> nodes; ///< from the bottom

    /// Empty: a sensor of the chain is not valid now, so there is no shape.
    static std::optional<ProfileZero> of(const std::vector<ChainNode> &nodes, UtcTime time);

    /// Over the foot of the chain; empty: the zero knows no such sensor at this height.
    std::optional<Displacement> at(const ChainNode &place) const;

    /// JSON in UTF-8: `time` (ISO 8601, UTC), `nodes`: [{`number`, `height`, `x`, `y`}], m and mm.
    QByteArray toJson() const;
    static std::optional<ProfileZero> fromJson(const QByteArray &json);

    bool operator==(const ProfileZero &) const = default;
};

/// Files with the zeros of chains, one a chain, in a folder of the site's data.
class ProfileZeroFiles
{
public:
    explicit ProfileZeroFiles(const QString &folder)
        : m_folder(folder)
    {
    }

    /// Empty: there is none, or the file makes no sense.
    std::optional<ProfileZero> load(int chain) const;
    /// False: see error().
    bool save(int chain, const ProfileZero &zero);
    bool remove(int chain);

    QString error() const { return m_error; } ///< file and reason

private:
    QString path(int chain) const;

    QString m_folder;
    QString m_error;
};

} // namespace gorizont
