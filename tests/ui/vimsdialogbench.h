#pragma once

#include "core/devices/lvims/lvimssimulator.h"
#include "tests/ui/dialogtester.h"
#include "tests/ui/servicebench.h"
#include "ui/service/vimsdialog.h"

#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QtTest>

namespace gorizont::test {

inline SensorConfig vims(int index, int number, int unit)
{
    SensorConfig sensor = serviceSensor(SensorType::LVims, index, number, 1);
    sensor.model = QStringLiteral("L-VIMS");
    sensor.name = QStringLiteral("Pump %1 (L-VIMS)").arg(number);
    sensor.options.insert(QStringLiteral("unit"), QString::number(unit));
    return sensor;
}

/// The service window of L-VIMS with a real worker on a simulated line, its widgets found by their names.
class VimsDialogBench : public DialogTester
{
public:
    explicit VimsDialogBench(const QList<SensorConfig> &ini, const BenchOptions &options = {})
        : bench(serviceLine(ini), ini, options)
    {
    }
    ~VimsDialogBench() { delete dialog.data(); }

    void start()
    {
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), LineState::Open, patience);
        dialog = new VimsDialog(bench.port());
        dialog->show();
        dialog->enter();
    }
    /// Until the settings of the first module are shown.
    void open()
    {
        start();
        waitForSettings();
    }
    void waitForSettings() { QTRY_VERIFY_WITH_TIMEOUT(dialog && button("applySettings")->isEnabled(), patience); }

    QString message() const { return text("serviceMessage"); }

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

    /// A register of the module that stands at \a index.
    int peek(int address, int index = 0)
    {
        return bench.device<lvims::Simulator>(index, [address](const lvims::Simulator &device) {
            return int(const_cast<lvims::Simulator &>(device).module().peek(address));
        });
    }
    /// Changes the module that stands at \a index, in the thread of the line.
    void change(const std::function<void(lvims::SimulatedModule &)> &how, int index = 0)
    {
        const auto promise = std::make_shared<QPromise<void>>();
        promise->start();
        bench.worker->submit([promise, how, index](Line &line) {
            const auto &bus = dynamic_cast<SimulatedLine &>(line).bus();
            how(dynamic_cast<lvims::Simulator &>(*bus.devices().at(static_cast<std::size_t>(index))).module());
            promise->finish();
        });
        promise->future().waitForFinished();
    }

    ServiceBench bench;
    QPointer<VimsDialog> dialog;

protected:
    QWidget *window() const override { return dialog; }
};

} // namespace gorizont::test
