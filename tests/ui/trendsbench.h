#pragma once

#include "tests/ui/plotsource.h"
#include "tests/ui/samplesite.h"
#include "ui/plots/trendplot.h"
#include "ui/plots/trendspage.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

namespace gorizont::test {

constexpr UtcTime present{std::chrono::seconds(1'800'000'000)};
constexpr SeriesKey tiltX{2, Quantity::TiltX};
constexpr SeriesKey temperature{1, Quantity::Temperature};

/// A page of trends over a source that answers when the test says so, its clock and settings those of the test.
class TrendsBench
{
protected:
    void useOwnSettings()
    {
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
    }
    void begin()
    {
        const QString program = QStringLiteral("Gorizont Server");
        QSettings(QSettings::NativeFormat, QSettings::UserScope, program, program).clear();
        m_now = present;
        m_source = std::make_unique<PlotSource>();
        m_registry = std::make_unique<SensorRegistry>(sampleConfig().lines, StatusRules());
        open();
    }
    void open()
    {
        m_page = std::make_unique<TrendsPage>(*m_registry, m_source->source(), nullptr, [this] { return m_now; });
        m_page->resize(1000, 600);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    }
    TrendPlot *plot() const { return m_page->findChild<TrendPlot *>(QStringLiteral("trendPlot")); }
    std::chrono::microseconds length() const { return plot()->span().to - plot()->span().from; }
    void answer(const QList<Series> &series) { m_source->answer(m_source->questions.size() - 1, series); }

    QTemporaryDir m_settings;
    UtcTime m_now;
    std::unique_ptr<PlotSource> m_source;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<TrendsPage> m_page;
};

} // namespace gorizont::test
