#include "core/config/inifile.h"
#include "core/opc/opclines.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

using namespace gorizont;

namespace {

void require(bool holds)
{
    if (!holds) {
        std::abort();
    }
}

/// Whatever the ini: every tag has a name of its own that parts at its dots into words, and all arrive whole in their order.
void checkTags(const QByteArray &ini)
{
    const QList<OpcTag> tags = opcTags(readServerConfig(IniFile::fromBytes(ini)).config.lines);
    QSet<QString> names;
    for (const OpcTag &tag : tags) {
        require(!names.contains(tag.name) && !tag.name.contains(u'\t') && !tag.name.contains(u'\n'));
        require(tag.name.count(u'[') == 3 && tag.name.count(u']') == 3 && tag.name.count(u'.') >= 3);
        names.insert(tag.name);
    }
    qsizetype next = 0;
    for (const QByteArray &line : opclines::tagLines(tags)) {
        require(line.endsWith('\n') && line.count('\n') == 1);
        const QJsonArray array = QJsonDocument::fromJson(line).object().value(QStringLiteral("tags")).toArray();
        require(!array.isEmpty() && array.size() <= opclines::mostTags);
        for (const QJsonValue &tag : array) {
            require(tag.toObject().value(QStringLiteral("name")).toString() == tags.at(next++).name);
        }
    }
    require(next == tags.size());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    checkTags(bytes);
    const auto greeting = opclines::greeting(bytes);
    require(!greeting || bytes.contains(':'));
    return 0;
}
