#pragma once

#include "core/alarms/alarmwatch.h"
#include "tests/ui/samplesite.h"
#include "ui/mainwindow.h"

#include <QAction>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

namespace gorizont::test {

/// The real window over the sample site, offscreen, its widgets found by their names, its settings those of the test.
class WindowBench
{
protected:
    void useOwnSettings()
    {
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
    }
    void begin()
    {
        m_config = sampleConfig();
        m_registry = std::make_unique<SensorRegistry>(m_config.lines, StatusRules());
        m_journal = std::make_unique<Journal>();
        m_alarms = std::make_unique<AlarmWatch>(*m_registry);
        open({});
    }
    void end()
    {
        m_window.reset();
        m_alarms.reset();
        m_journal.reset();
        m_registry.reset();
    }

    void open(const QList<Complaint> &complaints, bool isShown = true)
    {
        m_window = std::make_unique<MainWindow>(*m_registry, *m_journal, *m_alarms, m_config, complaints);
        if (isShown) {
            m_window->showAtStart();
            QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        }
    }

    template <typename T> T *find(const char *name) const
    {
        T *found = m_window->findChild<T *>(QLatin1String(name));
        if (!found) {
            qFatal("no widget %s", name);
        }
        return found;
    }

    void trigger(const char *action) const { find<QAction>(action)->trigger(); }

    QTemporaryDir m_settings;
    ServerConfig m_config;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<Journal> m_journal;
    std::unique_ptr<AlarmWatch> m_alarms;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace gorizont::test
