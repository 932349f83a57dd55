#pragma once

#include "core/devices/mk14/mk14simulator.h"
#include "tests/ui/dialogtester.h"
#include "tests/ui/servicebench.h"
#include "ui/service/mk14dialog.h"

#include <QMessageBox>
#include <QtTest>

namespace gorizont::test {

/// A weather station of the ini with the control word \a outputs.
inline SensorConfig station(int index, int number, int address, const QString &outputs = QStringLiteral("0"))
{
    SensorConfig sensor = serviceSensor(SensorType::Mk14, index, number, address);
    sensor.model = QStringLiteral("MK-14");
    sensor.measuresTilt = false;
    sensor.options.insert(QStringLiteral("outputs"), outputs);
    return sensor;
}

/// The service window of МК-14 with a real worker on a simulated line, its widgets found by their names.
class Mk14DialogBench : public DialogTester
{
public:
    Mk14DialogBench(
        const QList<SensorConfig> &ini, const QList<SensorConfig> &connected, const BenchOptions &options = {})
        : bench(serviceLine(ini), connected, options)
    {
    }
    ~Mk14DialogBench() override { delete dialog.data(); }

    void start()
    {
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), LineState::Open, patience);
        dialog = new Mk14Dialog(bench.port());
        dialog->show();
        dialog->enter();
    }
    /// Until the first station is shown.
    void open()
    {
        start();
        QTRY_VERIFY_WITH_TIMEOUT(dialog && button("setOutputs")->isEnabled(), patience);
    }

    QString message() const { return text("serviceMessage"); }

    void chooseValue(const char *name, const QVariant &data) const
    {
        auto *combo = find<QComboBox>(name);
        const int index = combo->findData(data);
        QVERIFY(index >= 0);
        combo->setCurrentIndex(index);
        Q_EMIT combo->activated(index);
    }

    /// What is asked before something is changed; empty: nothing.
    QString question() const
    {
        const auto *box = dialog->findChild<QMessageBox *>(QStringLiteral("serviceQuestion"));
        return box ? box->text() : QString();
    }
    void answer(bool isYes)
    {
        QTRY_VERIFY_WITH_TIMEOUT(!question().isEmpty(), patience);
        button(isYes ? "questionGo" : "questionStay")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog || question().isEmpty(), patience);
    }

    /// Changes the first station, in the thread of the line.
    void change(const std::function<void(mk14::Simulator &)> &how)
    {
        const auto promise = std::make_shared<QPromise<void>>();
        promise->start();
        bench.worker->submit([promise, how](Line &line) {
            const auto &bus = dynamic_cast<SimulatedLine &>(line).bus();
            how(dynamic_cast<mk14::Simulator &>(*bus.devices().front()));
            promise->finish();
        });
        promise->future().waitForFinished();
    }
    template <typename Seen> auto look(Seen seen) { return bench.device<mk14::Simulator>(0, seen); }

    /// The requests to \a address since forgetSent() with the command \a command.
    int sent(int address, int command) const
    {
        const QList<QByteArray> requests = bench.sent();
        return static_cast<int>(std::count_if(requests.begin(), requests.end(), [=](const QByteArray &request) {
            return request.size() >= 9 && static_cast<quint8>(request[0]) == 0xBB
                && static_cast<quint8>(request[1]) == address && static_cast<quint8>(request[2]) == command;
        }));
    }

    ServiceBench bench;
    QPointer<Mk14Dialog> dialog;

protected:
    QWidget *window() const override { return dialog; }
};

} // namespace gorizont::test
