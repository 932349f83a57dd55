#pragma once

#include "core/devices/ind3/ind3simulator.h"
#include "tests/ui/dialogtester.h"
#include "tests/ui/servicebench.h"
#include "ui/service/ind3dialog.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLineEdit>
#include <QtTest>

namespace gorizont::test {

inline SensorConfig inclinometer(int index, int number, int address, const QString &protocol = {})
{
    return serviceSensor(SensorType::InD, index, number, address, protocol);
}

inline const QList<SensorConfig> two{inclinometer(1, 1, 11), inclinometer(2, 2, 24)};

/// The service window of ИН-Д3 with a real worker on a simulated line, its widgets found by their names.
class Ind3DialogBench : public QObject, public DialogTester
{
protected:
    QWidget *window() const override { return m_dialog; }

    void close()
    {
        delete m_dialog.data();
        m_bench.reset();
    }

    void start(const QList<SensorConfig> &ini, const QList<SensorConfig> &connected, const BenchOptions &options = {})
    {
        m_bench = std::make_unique<ServiceBench>(serviceLine(ini), connected, options);
        QTRY_COMPARE_WITH_TIMEOUT(m_bench->state(), LineState::Open, patience);
        m_dialog = new Ind3Dialog(m_bench->port());
        m_dialog->show();
        m_dialog->enter();
    }

    /// Until the first sensor is shown.
    void open(const QList<SensorConfig> &ini, const QList<SensorConfig> &connected, const BenchOptions &options = {})
    {
        start(ini, connected, options);
        QTRY_VERIFY_WITH_TIMEOUT(find<QLineEdit>("offsetXEdit")->isEnabled(), patience);
    }

    void type(const char *name, const QString &text) const
    {
        auto *field = find<QLineEdit>(name);
        field->setFocus();
        field->selectAll();
        QGuiApplication::clipboard()->setText(text);
        text.isEmpty() ? field->del() : field->paste(); // QTest types Latin only
    }

    QByteArray nameOf(int index) const
    {
        return m_bench->device<ind3::Simulator>(index, [](const auto &device) { return device.sensor().name; });
    }

    std::unique_ptr<ServiceBench> m_bench;
    QPointer<Ind3Dialog> m_dialog;
};

} // namespace gorizont::test
