#include "core/adc24/adc24server.h"

#include "core/adc24/adc24answer.h"

namespace gorizont {

namespace {

/// One answer may have 16 KiB, so fewer requests a turn than elsewhere: 128 KiB of answers.
constexpr qint64 requestsPerTurn = 8;

Service adc24Service(const Adc24Image &image, std::chrono::milliseconds patience)
{
    Service service;
    service.name = QStringLiteral("ADC24 TCP");
    service.portKey = QStringLiteral("IPPort2");
    service.answer = [&image](QByteArrayView received, AnswerBuffer &answers) {
        return answerAdc24(received, image, answers);
    };
    service.readLimit = requestsPerTurn * adc24::requestSize;
    service.patience = patience;
    return service;
}

} // namespace

Adc24Server::Adc24Server(const Adc24Config &config, QObject *parent)
    : QObject(parent)
    , m_config(config)
    , m_image(config)
    , m_desk(adc24Service(m_image, config.patience), config.desk, this)
{
}

void Adc24Server::start()
{
    m_desk.open(m_config.desk.bind, static_cast<quint16>(m_config.port));
}

void Adc24Server::stop()
{
    m_desk.close();
}

void Adc24Server::updateReadings(const QList<Reading> &batch)
{
    for (const Reading &reading : batch) {
        m_image.update(reading);
    }
}

void Adc24Server::appendBlock(const SampleBlock &block)
{
    m_image.append(block);
}

} // namespace gorizont
