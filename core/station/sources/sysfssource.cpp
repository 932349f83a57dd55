#include "core/station/sources/sysfssource.h"

#include "core/station/sources/simulatedsource.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

namespace gorizont::station {

namespace {

constexpr qint64 longestNumber = 64; ///< bytes
constexpr double voltsPerMillivolt = 1e-3;

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::SysfsSource)
};

/// Empty: \a path cannot be read, or holds no number; \a why is then the reason.
std::optional<double> numberIn(const QString &path, QString *why)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered)) {
        *why = QDir::toNativeSeparators(path) + QStringLiteral(": ") + file.errorString();
        return std::nullopt;
    }
    const QByteArray text = file.read(longestNumber).trimmed();
    bool isNumber = false;
    const double value = text.toDouble(&isNumber);
    if (!isNumber) {
        *why = Text::tr("%1 holds no number").arg(QDir::toNativeSeparators(path));
        return std::nullopt;
    }
    return value;
}

/// A property of one input, else the one that all inputs of the device share, else \a other.
double propertyOf(const QDir &device, int input, const QString &property, double other)
{
    QString why;
    for (const QString &name :
         {QStringLiteral("in_voltage%1_%2").arg(input).arg(property), QStringLiteral("in_voltage_") + property}) {
        if (device.exists(name)) {
            return numberIn(device.filePath(name), &why).value_or(other);
        }
    }
    return other;
}

} // namespace

SysfsSource::SysfsSource(const SourcePlan &plan)
    : m_rate(plan.rate)
{
    for (const FileChannel &file : plan.files) {
        if (file.channel.kind != ChannelKind::Output) {
            m_files.append(file);
        }
    }
}

QString SysfsSource::name() const
{
    return Text::tr("inputs of the system");
}

QString SysfsSource::openIio(Input &input) const
{
    const QDir device(input.file.path);
    if (!device.exists()) {
        return Text::tr("there is no folder %1").arg(QDir::toNativeSeparators(input.file.path));
    }
    input.path = device.filePath(QStringLiteral("in_voltage%1_raw").arg(input.file.input));
    input.scale = propertyOf(device, input.file.input, QStringLiteral("scale"), 1) * voltsPerMillivolt;
    input.offset = propertyOf(device, input.file.input, QStringLiteral("offset"), 0);
    return {};
}

QString SysfsSource::open()
{
    m_inputs.clear();
    for (const FileChannel &file : m_files) {
        Input input;
        input.file = file;
        input.path = file.path;
        if (file.input >= 0) {
            if (const QString problem = openIio(input); !problem.isEmpty()) {
                return problem;
            }
        }
        m_inputs.append(input);
    }
    return {};
}

QString SysfsSource::measure(const SampleMoment &moment, RawSample &sample)
{
    for (Input &input : m_inputs) {
        QString why;
        const auto number = numberIn(input.path, &why);
        if (!number) {
            return why;
        }
        if (input.file.channel.kind == ChannelKind::Pulses) {
            countPulses(input, *number, moment, sample);
        } else if (input.file.channel.kind == ChannelKind::Digital) {
            addTo(sample, input.file.channel, *number != 0 ? 1 : 0);
        } else {
            addTo(sample, input.file.channel, (*number + input.offset) * input.scale);
        }
    }
    return {};
}

/// A count that has become smaller began anew: that step says nothing.
void SysfsSource::countPulses(Input &input, double count, const SampleMoment &moment, RawSample &sample) const
{
    const double passed = (moment.time - input.lastTime).count();
    if (input.lastCount && count >= *input.lastCount && passed > 0) {
        addTo(sample, input.file.channel, (count - *input.lastCount) / passed);
    }
    input.lastCount = count;
    input.lastTime = moment.time;
}

} // namespace gorizont::station
