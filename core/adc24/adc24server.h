#pragma once

#include "core/adc24/adc24image.h"
#include "core/net/clientdesk.h"

namespace gorizont {

/// Serves the samples of one accelerometer over ADC24 TCP (spec/gorizont.md, section 7). Servers thread.
class Adc24Server : public QObject
{
    Q_OBJECT

public:
    explicit Adc24Server(const Adc24Config &config, QObject *parent = nullptr);

    /// The clients, and what the journal is told. It lives in the thread of the server.
    ClientDesk &desk() { return m_desk; }

public Q_SLOTS:
    void start();
    void stop();
    void updateReadings(const QList<gorizont::Reading> &batch);
    void appendBlock(const gorizont::SampleBlock &block);

private:
    const Adc24Config m_config;
    Adc24Image m_image;
    ClientDesk m_desk; ///< after the image: its peers read it
};

} // namespace gorizont
