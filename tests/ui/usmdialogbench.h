#pragma once

#include "core/devices/usmisn/usmisnsimulator.h"
#include "tests/ui/dialogtester.h"
#include "tests/ui/servicebench.h"
#include "ui/service/usmdialog.h"

#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QtTest>

namespace gorizont::test {

/// An УСМ-ИСН of the ini: its serial number is 3590 + \a number.
inline SensorConfig usm(int index, int number, int address)
{
    SensorConfig sensor = serviceSensor(SensorType::UsmIsn, index, number, address);
    sensor.model = QStringLiteral("USM-ISN");
    return sensor;
}

/// The service window of УСМ-ИСН with a real worker on a simulated line, its widgets found by their names.
class UsmDialogBench : public DialogTester
{
public:
    UsmDialogBench(
        const QList<SensorConfig> &ini, const QList<SensorConfig> &connected, const BenchOptions &options = {})
        : bench(serviceLine(ini), connected, options)
    {
    }
    ~UsmDialogBench() { delete dialog.data(); }

    /// Begins to scan.
    void start(const KeepRecords &keep = {})
    {
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), LineState::Open, patience);
        ServicePort port = bench.port();
        const ServicePort kept{port.line, port.timing, port.worker, port.registry, port.journal, keep};
        dialog = new UsmDialog(
            kept, nullptr, {.silence = std::chrono::milliseconds(100), .betweenStops = std::chrono::milliseconds(1)});
        dialog->show();
        dialog->enter();
    }
    /// Until the first device is shown.
    void open(const KeepRecords &keep = {})
    {
        start(keep);
        QTRY_VERIFY_WITH_TIMEOUT(dialog && button("measure")->isEnabled(), patience);
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

    /// What is asked before something dangerous is done; empty: nothing.
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

    /// Changes the device that stands at \a index, in the thread of the line.
    void change(int index, const std::function<void(usmisn::Simulator &)> &how)
    {
        const auto promise = std::make_shared<QPromise<void>>();
        promise->start();
        bench.worker->submit([promise, how, index](Line &line) {
            const auto &bus = dynamic_cast<SimulatedLine &>(line).bus();
            how(dynamic_cast<usmisn::Simulator &>(*bus.devices().at(static_cast<std::size_t>(index))));
            promise->finish();
        });
        promise->future().waitForFinished();
    }
    /// Whether a request with \a part was sent since forgetSent().
    bool wasSent(const QByteArray &part) const
    {
        const QList<QByteArray> sent = bench.sent();
        return std::any_of(sent.begin(), sent.end(), [&part](const auto &request) { return request.contains(part); });
    }

    ServiceBench bench;
    QPointer<UsmDialog> dialog;

protected:
    QWidget *window() const override { return dialog; }
};

} // namespace gorizont::test
