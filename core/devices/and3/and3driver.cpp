#include "core/devices/and3/and3driver.h"

#include "core/devices/and3/and3packet.h"

#include <QCoreApplication>
#include <QLoggingCategory>

#include <algorithm>
#include <numbers>

namespace gorizont::and3 {

namespace {

Q_LOGGING_CATEGORY(logDevice, "gorizont.device.and3", QtInfoMsg)

using namespace std::chrono_literals;

/// A quantity that the sensor calls not ready is absent.
Measurement measurementOf(const ComplexRead &read)
{
    const auto isReady = [&](quint16 bit) { return (read.rawStatus & bit) != 0; };
    Measurement measurement;
    measurement.rawStatus = read.rawStatus;
    measurement.rawMode = read.rawMode;
    measurement.heaterPower = read.heaterPower;
    measurement.conditions = conditionsOf(read.rawStatus);
    if (isReady(statusbit::TiltReady)) {
        measurement.tilt = read.tilt;
    }
    if (isReady(statusbit::TemperatureReady)) {
        measurement.temperature = read.temperature;
    }
    if (isReady(statusbit::FanReady)) {
        measurement.fanFrequency = read.fanFrequency;
    }
    return measurement;
}

} // namespace

double accelerationScale(double gravity)
{
    constexpr double arcSeconds = 1.0 / 8;
    constexpr double radians = arcSeconds / 3600 * std::numbers::pi / 180;
    return -radians * gravity * 1000;
}

And3Driver::And3Driver(DriverSettings settings, Clock clock)
    : Driver(std::move(settings))
    , m_clock(std::move(clock))
    , m_ring(this->settings().sensor.number, accelerationScale(this->settings().gravity))
    , m_enquiry(this->settings().sensor.number)
{
}

Result<Measurement> And3Driver::poll(Line &line)
{
    m_mayFetch = false;
    const auto answer = ask(line, Request::complexRead(address()), forCommands());
    if (!answer) {
        return answer.fault();
    }
    const UtcTime now = m_clock();
    const auto read = parseComplexRead(*answer);
    if (!read) {
        return Fault::BadReply;
    }
    Measurement measurement = measurementOf(*read);
    const bool isRebooted = measurement.conditions.testFlag(Condition::Rebooted);
    const bool hasRebooted = isRebooted && !m_isRebooted;
    if (hasRebooted) {
        note(JournalKind::Info, QCoreApplication::translate("And3Driver", "The sensor has restarted."));
    }
    m_isRebooted = isRebooted;
    if (settings().sensor.measuresAcceleration) {
        followRing(*read, hasRebooted, now);
        measurement.ring = m_ring.progress();
    }
    if (const auto kept = keepInOrder(line, *read); !kept) {
        return kept.fault();
    }
    m_wantsEnquiry = settings().asksInformation && m_enquiry.isDue(now);
    measurement.conditions |= std::exchange(m_toReport, {});
    m_mayFetch = true;
    return measurement;
}

void And3Driver::followRing(const ComplexRead &read, bool hasRebooted, UtcTime now)
{
    switch (m_ring.observe(read.samples, hasRebooted, now)) {
    case RingReader::Change::None: break;
    case RingReader::Change::Restarted:
        if (!hasRebooted) {
            note(
                JournalKind::Info,
                QCoreApplication::translate("And3Driver", "The sensor counts its measurements anew."));
        }
        break;
    case RingReader::Change::Overran:
        m_toReport |= Condition::RingOverrun;
        note(
            JournalKind::Error,
            QCoreApplication::translate("And3Driver", "The buffer of accelerations overran, packets lost: %1.")
                .arg(m_ring.lost()));
        break;
    }
}

/// What the sensor should be told in the same turn. That a command stays unanswered spoils no reading: the sensor goes
/// on saying what is wrong, and the next turn tells it again.
Result<void> And3Driver::keepInOrder(Line &line, const ComplexRead &read)
{
    if (m_isRebooted) {
        if (const auto done = tell(line, Request::mode(address(), ModeBit::RebootAcknowledged, true)); !done) {
            return done;
        }
    }
    const bool isStopped = settings().sensor.measuresAcceleration && !read.isRecording();
    if (isStopped && !m_isStopped) {
        note(
            JournalKind::Info,
            QCoreApplication::translate(
                "And3Driver", "The recording of accelerations was stopped; it is started again."));
    }
    m_isStopped = isStopped;
    return isStopped ? tell(line, Request::mode(address(), ModeBit::RecordingStopped, false)) : Result<void>();
}

Result<void> And3Driver::tell(Line &line, const Request &request) const
{
    const auto answer = ask(line, request, forCommands());
    return answer || !isLineFault(answer.fault()) ? Result<void>() : answer.fault();
}

/// A sensor that does not answer this is not at fault; the question comes again in a minute.
Result<void> And3Driver::enquire(Line &line)
{
    const InformationKind kind = m_enquiry.next(m_clock());
    const auto answer = ask(line, Request::information(address(), kind), forCommands());
    if (!answer) {
        return isLineFault(answer.fault()) ? Result<void>(answer.fault()) : Result<void>();
    }
    const QString firmware = m_enquiry.known().firmware;
    if (m_enquiry.take(kind, *answer)) {
        report(m_enquiry.known());
    }
    if (m_enquiry.known().firmware != firmware) {
        note(
            JournalKind::Info,
            QCoreApplication::translate("And3Driver", "Firmware %1.").arg(m_enquiry.known().firmware));
    }
    return {};
}

bool And3Driver::hasBacklog() const
{
    return m_mayFetch && (m_wantsEnquiry || m_ring.available() > 0);
}

/// A question about the sensor itself goes first: it is one short exchange and comes six times a minute.
Result<QList<SampleBlock>> And3Driver::fetch(Line &line)
{
    if (!std::exchange(m_wantsEnquiry, false)) {
        return fetchPackets(line);
    }
    const auto asked = enquire(line);
    return asked ? Result<QList<SampleBlock>>(QList<SampleBlock>()) : asked.fault();
}

/// One exchange. After a fault nothing is fetched until a poll has shown that the sensor is there; the packets wait in
/// its ring.
Result<QList<SampleBlock>> And3Driver::fetchPackets(Line &line)
{
    const RingReader::Step step = m_ring.nextStep();
    const auto request =
        Request::packets(address(), static_cast<quint8>(step.firstCell), static_cast<quint8>(step.count));
    const auto answer = ask(line, request, forData());
    if (!answer) {
        m_mayFetch = false;
        return answer.fault();
    }
    const auto packets = parsePackets(*answer);
    if (!packets) {
        m_mayFetch = false;
        return Fault::BadReply;
    }
    const RingReader::Taken taken = m_ring.take(*packets);
    if (taken.rejected > 0) {
        qCInfo(logDevice) << "sensor" << settings().sensor.number << "sent packets of bad quality:" << taken.rejected;
    }
    if (taken.isOutOfStep) {
        m_toReport |= Condition::SyncError;
        if (!m_isOutOfStep) {
            note(
                JournalKind::Error,
                QCoreApplication::translate("And3Driver", "Packets of accelerations do not follow each other."));
        }
    }
    m_isOutOfStep = taken.isOutOfStep;
    return taken.blocks;
}

/// Where the reading of the ring goes on is decided by the count of the next poll: what is still there is not lost.
void And3Driver::restart()
{
    m_mayFetch = false;
    m_wantsEnquiry = false;
}

/// Asks once more when a late answer to an earlier request had come before the time was over.
Result<QByteArray> And3Driver::ask(Line &line, const Request &request, Patience patience) const
{
    bool passedLateAnswer = false;
    Exchange exchange;
    exchange.request = request.toBytes();
    exchange.scan = [&](QByteArrayView received) {
        const Search search = findAnswer(received, request);
        passedLateAnswer = passedLateAnswer || search.passedLateAnswer;
        return search.scan;
    };
    exchange.writeTimeout = patience.write;
    exchange.readTimeout = patience.read;
    exchange.quietBefore = std::max<std::chrono::microseconds>(leastSilence, settings().timing.addressChange);
    const auto answer = line.exchange(exchange);
    const bool isWorthAnother = !answer && answer.fault() == Fault::Timeout && passedLateAnswer;
    return isWorthAnother ? line.exchange(exchange) : answer;
}

std::unique_ptr<Driver> makeDriver(DriverSettings settings)
{
    return std::make_unique<And3Driver>(std::move(settings));
}

} // namespace gorizont::and3
