#include "ui/models/sitetreemodel.h"

#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"

#include <QAbstractItemModelTester>
#include <QIcon>
#include <QSignalSpy>
#include <QtTest>

using namespace gorizont;

class TestTreeModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_registry = std::make_unique<SensorRegistry>(test::sampleConfig().lines, StatusRules());
        m_model = std::make_unique<SiteTreeModel>(*m_registry);
        m_tester = std::make_unique<QAbstractItemModelTester>(
            m_model.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    void cleanup()
    {
        m_tester.reset();
        m_model.reset();
        m_registry.reset();
    }

    void nodes()
    {
        QCOMPARE(
            test::modelText(*m_model),
            QStringLiteral("Server\n"
                           "  COM4\n"
                           "    1 АН-Д3 [Этаж 2] [12]\n"
                           "    2 ИН-Д3 [24]\n"
                           "  COM9\n"
                           "    3 ИН-Д3 [5]\n"
                           "    4 ИН-Д3 [6]\n"
                           "  COM2"));
    }

    void itemsAndIndexes()
    {
        for (const SiteItem item : {SiteItem::server(), SiteItem::line(1), SiteItem::sensor(2)}) {
            QCOMPARE(m_model->itemAt(m_model->indexOf(item)), item);
        }
        QCOMPARE(m_model->indexOf(SiteItem::sensor(2)).parent(), m_model->indexOf(SiteItem::line(1)));
    }

    /// A name may hold a percent sign and a digit.
    void placeIsTakenAsItIs()
    {
        ServerConfig config = test::sampleConfig();
        config.lines[0].sensors[0].place = QStringLiteral("%1 %2");
        const SensorRegistry registry(config.lines, StatusRules());
        const SiteTreeModel model(registry);
        QCOMPARE(model.indexOf(SiteItem::sensor(0)).data().toString(), QStringLiteral("1 АН-Д3 [%1 %2] [12]"));
    }

    void onlyChangedStatesAreAnnounced()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        m_registry->updateLine(test::openLine(1, now));
        m_registry->updateLine(test::openLine(2, now));
        m_registry->update(
            {test::sampleReading(now), test::tiltReading(2, 0, 0, now), test::tiltReading(3, 0, 0, now)});
        m_model->refresh();
        QCOMPARE(m_model->shownHealth(SiteItem::server()), Health::Good);
        QCOMPARE(m_model->shownHealth(SiteItem::sensor(3)), Health::Off);

        QSignalSpy changed(m_model.get(), &QAbstractItemModel::dataChanged);
        m_registry->update({test::tiltReading(2, 5, 5, now), test::tiltReading(3, 5, 5, now)});
        m_model->refresh();
        QCOMPARE(changed.size(), 0);

        Reading silent = test::tiltReading(3, 0, 0, now);
        silent.status = 0x3700;
        m_registry->update({silent});
        m_model->refresh();
        QCOMPARE(m_model->shownHealth(SiteItem::sensor(2)), Health::Error);
        QCOMPARE(m_model->shownHealth(SiteItem::line(1)), Health::Warning);
        QCOMPARE(m_model->shownHealth(SiteItem::server()), Health::Warning);
        QCOMPARE(changed.size(), 3);
        QCOMPARE(changed.at(0).at(0).toModelIndex(), m_model->indexOf(SiteItem::sensor(2)));
    }

    void iconsFollowTheState()
    {
        const auto key = [this](SiteItem item) {
            return m_model->indexOf(item).data(Qt::DecorationRole).value<QIcon>().cacheKey();
        };
        QVERIFY(key(SiteItem::sensor(0)) != key(SiteItem::sensor(1))); // АН-Д3, ИН-Д3
        QCOMPARE(key(SiteItem::sensor(1)), key(SiteItem::sensor(2)));
        QVERIFY(key(SiteItem::sensor(2)) != key(SiteItem::sensor(3))); // starting, off
    }

private:
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<SiteTreeModel> m_model;
    std::unique_ptr<QAbstractItemModelTester> m_tester;
};

QTEST_MAIN(TestTreeModel)
#include "tst_treemodel.moc"
