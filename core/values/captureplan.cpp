#include "core/values/captureplan.h"

#include <QCoreApplication>

#include <utility>

namespace gorizont {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

struct PlanText
{
    Q_DECLARE_TR_FUNCTIONS(CapturePlan)
};

/// Reads the options of one sensor; what it does not understand becomes a complaint.
class Reader
{
public:
    Reader(const SensorConfig &sensor, QStringList &complaints)
        : m_sensor(sensor)
        , m_complaints(complaints)
    {
    }

    int number(const QString &key, int most)
    {
        const QString text = value(key);
        bool isNumber = false;
        const int found = text.toInt(&isNumber);
        if (text.isEmpty() || (isNumber && found >= 0 && found <= most)) {
            return found;
        }
        complain(key, text, u"0…%1"_s.arg(most));
        return 0;
    }

    /// Which of \a words the option lists; \a usual when it is absent or one of them is not understood.
    template <typename T> QList<T> list(const QString &key, const QList<std::pair<QString, T>> &words, QList<T> usual)
    {
        QList<T> found;
        for (const QString &part : value(key).split(u',', Qt::SkipEmptyParts)) {
            const auto word = std::find_if(words.begin(), words.end(), [&part](const auto &known) {
                return part.trimmed().compare(known.first, Qt::CaseInsensitive) == 0;
            });
            if (word == words.end()) {
                complain(key, part.trimmed(), allOf(words));
                return usual;
            }
            if (!found.contains(word->second)) {
                found.append(word->second);
            }
        }
        return found.isEmpty() ? usual : found;
    }

private:
    QString value(const QString &key) const { return m_sensor.options.value(key.toLower()).trimmed(); }

    template <typename T> static QString allOf(const QList<std::pair<QString, T>> &words)
    {
        QStringList all;
        for (const auto &[word, meaning] : words) {
            all.append(word);
        }
        return all.join(u", "_s);
    }

    void complain(const QString &key, const QString &text, const QString &possible)
    {
        m_complaints.append(PlanText::tr("%1%2: \"%3\" is not understood; it takes %4. Its usual value is used.")
                                .arg(key)
                                .arg(m_sensor.index)
                                .arg(text, possible));
    }

    const SensorConfig &m_sensor;
    QStringList &m_complaints;
};

} // namespace

CapturePlan CapturePlan::from(const SensorConfig &sensor)
{
    constexpr int longest = 86400;
    constexpr int mostDays = 36500;
    enum class Format : quint8 { Csv, Wav };
    CapturePlan plan;
    Reader reader(sensor, plan.complaints);
    plan.every = std::chrono::seconds(reader.number(u"CaptureEvery"_s, longest));
    plan.keep = std::chrono::days(reader.number(u"CaptureKeep"_s, mostDays));
    plan.channels =
        reader.list<int>(u"CaptureChannels"_s, {{u"0"_s, 0}, {u"1"_s, 1}, {u"2"_s, 2}, {u"3"_s, 3}}, plan.channels);
    plan.kinds = reader.list<CaptureKind>(
        u"CaptureKinds"_s,
        {{u"waveform"_s, CaptureKind::Waveform},
         {u"5000"_s, CaptureKind::Spectrum5000},
         {u"200"_s, CaptureKind::Spectrum200}},
        plan.kinds);
    const auto formats =
        reader.list<Format>(u"CaptureFormat"_s, {{u"csv"_s, Format::Csv}, {u"wav"_s, Format::Wav}}, {Format::Csv});
    plan.savesCsv = formats.contains(Format::Csv);
    plan.savesWav = formats.contains(Format::Wav);
    return plan;
}

} // namespace gorizont
