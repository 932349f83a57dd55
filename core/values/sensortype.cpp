#include "core/values/sensortype.h"

#include <QStringView>

#include <array>
#include <limits>

namespace gorizont {

namespace {

struct ModelName
{
    QStringView latin;
    QStringView russian;
    QStringView folded; ///< what fold() makes of either spelling
    SensorType type;
};

constexpr std::array<ModelName, 8> models{{
    {u"IN-D2", u"ИН-Д2", u"IH-D2", SensorType::InD},
    {u"IN-D3", u"ИН-Д3", u"IH-D3", SensorType::InD},
    {u"IN-D7", u"ИН-Д7", u"IH-D7", SensorType::InD},
    {u"IN-D9", u"ИН-Д9", u"IH-D9", SensorType::InD},
    {u"AN-D3", u"АН-Д3", u"AH-D3", SensorType::AnD3},
    {u"USM-ISN", u"УСМ-ИСН", u"USM-ISH", SensorType::UsmIsn},
    {u"L-VIMS", u"L-VIMS", u"L-BIMS", SensorType::LVims},
    {u"MK-14", u"МК-14", u"MK-14", SensorType::Mk14},
}};

/// One letter for all that look or sound alike, so that a keyword matches however it was typed or scanned.
QChar foldCharacter(QChar c)
{
    switch (c.unicode()) {
    case u'А': return u'A';
    case u'В':
    case u'V': return u'B';
    case u'Д': return u'D';
    case u'З': return u'3';
    case u'И': return u'I';
    case u'Н':
    case u'N': return u'H';
    case u'М': return u'M';
    case u'К': return u'K';
    case u'У': return u'U';
    case u'С': return u'S';
    case u'Т': return u'T';
    case u'Р': return u'P';
    case u'‐':
    case u'‑':
    case u'‒':
    case u'–':
    case u'—':
    case u'―':
    case u'−':
    case u'﹘':
    case u'－': return u'-';
    default: return c;
    }
}

QString fold(const QString &text)
{
    QString folded = text.toUpper();
    for (QChar &c : folded) {
        c = foldCharacter(c);
    }
    return folded;
}

bool isInParentheses(const QString &text, qsizetype position)
{
    const qsizetype opened = text.lastIndexOf(u'(', position);
    return opened >= 0 && text.lastIndexOf(u')', position) < opened;
}

/// The keyword must end where its digits end: `IN-D34` is not `IN-D3`.
bool endsThere(const QString &text, qsizetype end)
{
    return end >= text.size() || !text.at(end).isDigit();
}

const ModelName *findModel(const QString &folded)
{
    const ModelName *found = nullptr;
    qsizetype bestRank = std::numeric_limits<qsizetype>::max();
    for (const ModelName &model : models) {
        for (qsizetype at = folded.indexOf(model.folded); at >= 0; at = folded.indexOf(model.folded, at + 1)) {
            if (!endsThere(folded, at + model.folded.size())) {
                continue;
            }
            const qsizetype rank = isInParentheses(folded, at) ? at - folded.size() : at;
            if (rank < bestRank) {
                bestRank = rank;
                found = &model;
            }
        }
    }
    return found;
}

} // namespace

NameKeywords readKeywords(const QString &name)
{
    const QString folded = fold(name);
    NameKeywords keywords;
    if (const ModelName *model = findModel(folded)) {
        keywords.type = model->type;
        keywords.model = model->latin.toString();
    }
    static const QString temperature = fold(QStringLiteral("TMP05"));
    static const QString acceleration = fold(QStringLiteral("ускорение"));
    static const QString heating = fold(QStringLiteral("подогрев"));
    keywords.hasThermometer = folded.contains(temperature);
    keywords.hasAcceleration = folded.contains(acceleration);
    keywords.hasThermostat = folded.contains(heating);
    return keywords;
}

QString modelInRussian(const QString &model)
{
    for (const ModelName &known : models) {
        if (known.latin == model) {
            return known.russian.toString();
        }
    }
    return model;
}

} // namespace gorizont
