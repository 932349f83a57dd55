#include "tests/ui/modeltext.h"
#include "tests/ui/weathersite.h"
#include "translations/translation.h"
#include "ui/models/sensormodel.h"
#include "ui/models/stateproperties.h"
#include "ui/pages/tableview.h"
#include "ui/weather/inputlamps.h"
#include "ui/weather/precipitationmodel.h"
#include "ui/weather/weathermodel.h"
#include "ui/weather/weatherpage.h"
#include "ui/weather/windroseview.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QSignalSpy>
#include <QToolTip>
#include <QtTest>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

/// The page <Погода>, and what the older pages show of a weather station.
class TestWeatherPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(installTranslation(u"ru"_s)); }
    void init() { open(1); }
    void cleanup()
    {
        m_page.reset();
        m_registry.reset();
    }

    void belongsToSitesWithAStation();
    void beforeTheFirstAnswer();
    void showsWhatTheStationSays();
    void invalidValuesAreDashes();
    void windAsNumbers();
    void roseGathersWhileNobodyLooks();
    void roseOverASpan();
    void choosesAmongStations();
    void namesOfTheFile();
    void noData();
    void badSupply();
    void portIsOff();
    void lostStationShowsNothingOld();
    void lampsTellOnFromOff();
    void rain();
    void rainOfAUtcStation();
    void rainWithoutItsOtherEnd();
    void filesOfAStationInThisProgram();
    void drawsOnlyWhenSeen();
    void isCopied();
    void fitsASmallWindow();
    void modelsKeepTheRules();
    void sensorPageAndTable();

private:
    void open(int stations, const QHash<QString, QString> &options = {});
    void answer(const Weather &weather, int number = 7);
    template <typename T> T *find(const char *name) const
    {
        T *found = m_page->findChild<T *>(QString::fromLatin1(name));
        if (!found) {
            qFatal("no widget %s", name);
        }
        return found;
    }
    QString row(const char *table, int row) const;
    QString wind(const QString &name) const;
    QString text(const char *label) const { return find<QLabel>(label)->text(); }

    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<WeatherPage> m_page;
    QDateTime m_now{QDate(2026, 11, 28), QTime(12, 0)};
};

void TestWeatherPage::open(int stations, const QHash<QString, QString> &options)
{
    ServerConfig config = test::weatherConfig(stations);
    config.lines[1].sensors.last().options = options;
    m_page.reset();
    m_registry = std::make_unique<SensorRegistry>(config.lines, StatusRules());
    m_registry->updateLine(test::openLine(2, std::chrono::steady_clock::now()));
    m_page = std::make_unique<WeatherPage>(*m_registry, nullptr, [this] { return m_now; });
}

void TestWeatherPage::answer(const Weather &weather, int number)
{
    m_registry->update({test::weatherReading(number, weather, std::chrono::steady_clock::now())});
    m_page->refresh();
}

QString TestWeatherPage::row(const char *table, int row) const
{
    const QAbstractItemModel *model = find<TableView>(table)->model();
    QStringList cells;
    for (int column = 0; column < model->columnCount(); ++column) {
        cells += model->index(row, column).data().toString();
    }
    return cells.join(u" | "_s);
}

QString TestWeatherPage::wind(const QString &name) const
{
    const QAbstractItemModel *model = find<TableView>("windTable")->model();
    for (int row = 0; row < model->rowCount(); ++row) {
        if (model->index(row, 0).data().toString() == name) {
            return model->index(row, 1).data().toString();
        }
    }
    return u"there is no such row"_s;
}

void TestWeatherPage::belongsToSitesWithAStation()
{
    QVERIFY(WeatherPage::hasStation(*m_registry));
    const SensorRegistry none(test::sampleConfig().lines, StatusRules());
    QVERIFY(!WeatherPage::hasStation(none));
    const WeatherPage page(none);
    QCOMPARE(page.station(), 0);
    QVERIFY(page.findChild<QLabel *>(u"weatherStatus"_s)->text().contains(u"МК-14"_s));
}

void TestWeatherPage::beforeTheFirstAnswer()
{
    QCOMPARE(text("weatherStatus"), u"Ожидание первого ответа."_s);
    QCOMPARE(text("weatherAge"), QString());
    QCOMPARE(find<TableView>("weatherTable")->model()->rowCount(), 0);
    QVERIFY(find<TableView>("weatherTable")->emptyText().startsWith(u"Станция ещё не отвечала."_s));
    QVERIFY(!find<InputLamps>("inputLamps")->inputs());
    QCOMPARE(text("inputWord"), u"—"_s);
    QCOMPARE(wind(u"Направление"_s), u"—"_s);
    QCOMPARE(wind(u"Отсчётов"_s), u"0"_s);
    QVERIFY(find<WindRoseView>("windRose")->accessibleDescription().contains(u"не было"_s));
}

void TestWeatherPage::showsWhatTheStationSays()
{
    answer(test::sampleWeather());
    QCOMPARE(text("weatherStatus"), u"Отвечает."_s);
    QCOMPARE(text("weatherAge"), u"Возраст данных: 00:00"_s);
    QCOMPARE(find<TableView>("weatherTable")->model()->rowCount(), 6);
    QCOMPARE(row("weatherTable", 0), u"Напряжение питания | U1 | В | 12.0 | 12.1 | 11.9 | 12.2 | — | — | 4.013 | —"_s);
    QCOMPARE(row("weatherTable", 1), u"Температура | T1 | °C | -3.25 | -3.20 | -3.50 | -3.00 | — | — | — | —"_s);
    QCOMPARE(row("weatherTable", 5), u"Скорость ветра | M1 | м/с | 4.1 | 3.9 | 2.0 | 6.8 | 7.3 | 0.82 | — | —"_s);
    QCOMPARE(text("inputWord"), u"0x80000011 (0, 4, 31)"_s);
}

void TestWeatherPage::invalidValuesAreDashes()
{
    Weather weather = test::sampleWeather();
    weather.parameters[1] = test::withoutValue(weather.parameters[1]);
    answer(weather);
    QCOMPARE(row("weatherTable", 1), u"Температура | T1 | °C | — | — | — | — | — | — | — | —"_s);
    QCOMPARE(text("weatherStatus"), u"Отвечает: температура не готова."_s);
    weather.parameters.removeAt(1); // it has no thermometer
    answer(weather);
    QCOMPARE(text("weatherStatus"), u"Отвечает."_s);
    weather = test::sampleWeather();
    for (WeatherParameter &parameter : weather.parameters) {
        parameter = test::withoutValue(parameter);
    }
    answer(weather);
    QCOMPARE(text("weatherStatus"), u"Станция отвечает, но ни одно из её значений не достоверно."_s);
    QCOMPARE(wind(u"Скорость, м/с"_s), u"—"_s);
    QCOMPARE(wind(u"Отсчётов"_s), u"2"_s); // of the answers before
}

void TestWeatherPage::windAsNumbers()
{
    answer(test::sampleWeather());
    QCOMPARE(wind(u"Направление"_s), u"225° ЮЗ"_s);
    QCOMPARE(wind(u"Направление сейчас"_s), u"230° ЮЗ"_s);
    QCOMPARE(wind(u"Скорость, м/с"_s), u"4.1"_s);
    QCOMPARE(wind(u"Скорость сейчас, м/с"_s), u"3.9"_s);
    QCOMPARE(wind(u"Порыв, м/с"_s), u"6.8"_s);
    QCOMPARE(wind(u"Порыв с прошлого запроса, м/с"_s), u"7.3"_s);
    QCOMPARE(wind(u"σ направления, °"_s), u"11.3"_s);
    QCOMPARE(wind(u"σ скорости, м/с"_s), u"0.82"_s);
    QCOMPARE(wind(u"U, V, м/с"_s), u"+2.9 +2.9"_s); // 4.14·sin 45.4°, 4.14·cos 45.4°
}

void TestWeatherPage::roseGathersWhileNobodyLooks()
{
    Weather weather = test::sampleWeather();
    const SteadyTime now = std::chrono::steady_clock::now();
    for (int i = 0; i < 3; ++i) {
        m_registry->update({test::weatherReading(7, weather, now)});
    }
    weather.parameters[4].mean = 90;
    m_registry->update({test::weatherReading(7, weather, now)});
    Reading state = test::weatherReading(7, weather, now); // only the state changed: no new wind
    state.isAnswer = false;
    m_registry->update({state});
    m_page->refresh();
    QCOMPARE(wind(u"Отсчётов"_s), u"4"_s);
    QCOMPARE(wind(u"Преобладает направление"_s), u"ЮЗ (75.0 %)"_s);
    QCOMPARE(wind(u"Наибольший порыв, м/с"_s), u"7.3"_s);
    QCOMPARE(
        find<WindRoseView>("windRose")->accessibleDescription(),
        u"Ветер сейчас: 230° ЮЗ, 3.9 м/с. Доли за 1 час: В 25 %, ЮЗ 75 %, штиль 0 %."_s);
}

void TestWeatherPage::roseOverASpan()
{
    const SteadyTime now = std::chrono::steady_clock::now();
    m_registry->update({test::weatherReading(7, test::sampleWeather(), now - 30min)});
    m_registry->update({test::weatherReading(7, test::sampleWeather(), now)});
    m_page->refresh();
    QCOMPARE(wind(u"Отсчётов"_s), u"2"_s);
    find<QComboBox>("windSpan")->setCurrentIndex(0);
    QCOMPARE(wind(u"Отсчётов"_s), u"1"_s);
}

void TestWeatherPage::choosesAmongStations()
{
    QVERIFY(!find<QComboBox>("stationBox")->isEnabled());
    open(2);
    QVERIFY(find<QComboBox>("stationBox")->isEnabled());
    Weather other = test::sampleWeather();
    other.parameters[5].mean = 9;
    answer(test::sampleWeather(), 7);
    answer(other, 8);
    QCOMPARE(m_page->station(), 7);
    QCOMPARE(wind(u"Скорость, м/с"_s), u"4.1"_s);
    m_page->showStation(8);
    QCOMPARE(find<QComboBox>("stationBox")->currentText(), u"8 МК-14 [Крыша] [2]"_s);
    QCOMPARE(wind(u"Скорость, м/с"_s), u"9.0"_s);
    QCOMPARE(wind(u"Отсчётов"_s), u"1"_s);
}

/// What ACK.PAR names with a dash has no name.
void TestWeatherPage::namesOfTheFile()
{
    Weather weather = test::sampleWeather();
    weather.parameters[1].name = u"Температура мачты"_s;
    weather.parameters[1].unit = u"град."_s;
    weather.parameters[1].number = 2;
    weather.parameters[3] = WeatherParameter();
    weather.parameters[3].code = u'x';
    weather.parameters[3].number = 12;
    weather.parameters[3].mean = 1.5;
    answer(weather);
    QVERIFY(row("weatherTable", 1).startsWith(u"Температура мачты | T2 | град. | -3.25"_s));
    QVERIFY(row("weatherTable", 3).startsWith(u"— | x12 | — | 1.50"_s));
}

void TestWeatherPage::noData()
{
    answer(Weather());
    QCOMPARE(text("weatherStatus"), u"Станция отвечает, но у неё ещё нет данных."_s);
    QCOMPARE(find<TableView>("weatherTable")->model()->rowCount(), 0);
    QVERIFY(find<TableView>("weatherTable")->emptyText().startsWith(u"У станции нет данных."_s));
    QCOMPARE(text("inputWord"), u"0x00000000 (ни один не включён)"_s);
}

void TestWeatherPage::badSupply()
{
    Reading reading = test::weatherReading(7, test::sampleWeather(), std::chrono::steady_clock::now());
    reading.status |= 0x5000;
    reading.weather->parameters[0].mean.reset();
    m_registry->update({reading});
    m_page->refresh();
    QVERIFY(text("weatherStatus").startsWith(u"Напряжение питания датчиков станции не в норме: "_s));
    QVERIFY(row("weatherTable", 0).startsWith(u"Напряжение питания | U1 | В | — |"_s));
}

void TestWeatherPage::portIsOff()
{
    ServerConfig config = test::weatherConfig();
    config.lines[1].isOn = false;
    m_page.reset();
    m_registry = std::make_unique<SensorRegistry>(config.lines, StatusRules());
    m_page = std::make_unique<WeatherPage>(*m_registry);
    QCOMPARE(text("weatherStatus"), u"Порт выключен."_s);
    config.lines[1].isOn = true;
    config.lines[1].sensors.last().isOn = false;
    m_page.reset();
    m_registry = std::make_unique<SensorRegistry>(config.lines, StatusRules());
    m_page = std::make_unique<WeatherPage>(*m_registry);
    QCOMPARE(text("weatherStatus"), u"Опрос отключен."_s);
}

/// What was measured before is not shown as if it were measured now; that it rained stays true.
void TestWeatherPage::lostStationShowsNothingOld()
{
    Weather weather = test::sampleWeather();
    weather.events = {{true, 1764331200}};
    answer(weather);
    Reading lost = test::weatherReading(7, weather, std::chrono::steady_clock::now() - 65s);
    lost.isAnswer = false;
    lost.status = 0x3700;
    m_registry->update({lost});
    m_page->refresh();
    QCOMPARE(text("weatherAge"), u"Возраст данных: 01:05"_s);
    QCOMPARE(row("weatherTable", 5), u"Скорость ветра | M1 | м/с | — | — | — | — | — | — | — | —"_s);
    QCOMPARE(wind(u"Скорость сейчас, м/с"_s), u"—"_s);
    QVERIFY(!find<InputLamps>("inputLamps")->inputs());
    QCOMPARE(find<TableView>("rainTable")->model()->rowCount(), 1);
    LineStatus service = test::openLine(2, std::chrono::steady_clock::now());
    service.state = LineState::Service;
    answer(weather);
    QCOMPARE(wind(u"Скорость сейчас, м/с"_s), u"3.9"_s);
    m_registry->updateLine(service);
    m_page->refresh();
    QCOMPARE(wind(u"Скорость сейчас, м/с"_s), u"—"_s);
}

/// By shape too: painted without a colour, a lamp that is on covers more.
void TestWeatherPage::lampsTellOnFromOff()
{
    InputLamps lamps;
    QPalette grey = lamps.palette();
    grey.setColor(QPalette::Window, Qt::white);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::Highlight}) {
        grey.setColor(role, Qt::black);
    }
    lamps.setPalette(grey);
    lamps.resize(lamps.sizeHint());
    const auto ink = [&lamps](int input) {
        const QImage image = lamps.grab(lamps.lampRect(input)).toImage();
        int sum = 0;
        for (int y = 0; y < 13; ++y) {
            for (int x = 0; x < image.width(); ++x) {
                sum += 255 - qGray(image.pixel(x, y));
            }
        }
        return sum;
    };
    lamps.setInputs(1U << 17);
    const int on = ink(17);
    const int off = ink(16);
    lamps.setInputs({});
    const int unknown = ink(16);
    QVERIFY2(on > 2 * off, qPrintable(u"%1 %2"_s.arg(on).arg(off)));
    QVERIFY2(off > 2 * unknown, qPrintable(u"%1 %2"_s.arg(off).arg(unknown)));
    QCOMPARE(lamps.lampAt(lamps.lampRect(17).center()), 17);
    QCOMPARE(lamps.lampAt(QPoint(-1, 0)), -1);
    lamps.setInputs(1U << 17);
    QHelpEvent help(QEvent::ToolTip, lamps.lampRect(17).center(), QPoint(1, 1));
    QCoreApplication::sendEvent(&lamps, &help);
    QCOMPARE(QToolTip::text(), u"Вход 17: включён"_s);
    QCOMPARE(lamps.accessibleDescription(), u"0x00020000 (17)"_s);
}

/// The clock of the station shows local time: its seconds are read as a wall clock. 1795867200 is 28.11.2026 12:00:00.
void TestWeatherPage::rain()
{
    QCOMPARE(QDateTime(QDate(2026, 11, 28), QTime(12, 0), Qt::UTC).toSecsSinceEpoch(), 1795867200);
    Weather weather = test::sampleWeather();
    weather.events = {{true, 1795867200 - 90}, {false, 1795867200 - 3600}, {true, 1795867200 - 7265}};
    answer(weather);
    QCOMPARE(find<TableView>("rainTable")->model()->rowCount(), 2);
    QCOMPARE(row("rainTable", 0), u"28.11.2026 11:58:30 | идут | 0:01:30"_s);
    QCOMPARE(row("rainTable", 1), u"28.11.2026 09:58:55 | 28.11.2026 11:00:00 | 1:01:05"_s);
    m_now = m_now.addSecs(60);
    m_page->refresh();
    QCOMPARE(row("rainTable", 0), u"28.11.2026 11:58:30 | идут | 0:02:30"_s);
    m_now = m_now.addSecs(-60);
}

void TestWeatherPage::rainOfAUtcStation()
{
    open(1, {{u"stationclock"_s, u"utc"_s}});
    Weather weather = test::sampleWeather();
    const qint64 begin = m_now.toSecsSinceEpoch() - 3600;
    weather.events = {{true, begin}};
    answer(weather);
    QCOMPARE(row("rainTable", 0), u"28.11.2026 11:00:00 | идут | 1:00:00"_s);
    const QDateTime summer(QDate(2026, 7, 1), QTime(3, 4, 5));
    for (const auto clock : {precipitation::StationClock::Local, precipitation::StationClock::Utc}) {
        QCOMPARE(precipitation::localTime(precipitation::stationTime(summer, clock), clock), summer);
    }
}

void TestWeatherPage::rainWithoutItsOtherEnd()
{
    QVERIFY(precipitation::spells({}).isEmpty());
    // The station remembers ten events: the oldest may be an end.
    QCOMPARE(
        precipitation::spells({{false, 50}, {true, 40}, {false, 30}}),
        QList<Precipitation>({{40, 50, false}, {{}, 30, false}}));
    // It was restarted while it rained.
    QCOMPARE(precipitation::spells({{true, 60}, {true, 40}}), QList<Precipitation>({{60, {}, true}, {40, {}, false}}));
    Weather weather = test::sampleWeather();
    weather.events = {{false, 50}, {true, 60}, {true, 40}};
    answer(weather);
    QCOMPARE(row("rainTable", 0), u"01.01.1970 00:01:00 | 01.01.1970 00:00:50 | —"_s); // its clock was set back
    QCOMPARE(row("rainTable", 1), u"01.01.1970 00:00:40 | — | —"_s);
}

void TestWeatherPage::filesOfAStationInThisProgram()
{
    open(2);
    m_page->setFileComplaints(
        8,
        {{u"ACK.PAR"_s, 3, 9, u"левая граница"_s, u"Это не число."_s, u"Параметр пропущен."_s},
         {u"ACK.PSE"_s, 0, 0, {}, u"Файла нет."_s, {}}});
    const auto *table = find<TableView>("stationFilesTable");
    QVERIFY(table->isHidden()); // N 7 has none
    m_page->showStation(8);
    QVERIFY(!table->isHidden());
    QCOMPARE(table->model()->rowCount(), 2);
    QCOMPARE(row("stationFilesTable", 0), u"ACK.PAR | 3 | 9 (левая граница) | Это не число. | Параметр пропущен."_s);
    QCOMPARE(row("stationFilesTable", 1), u"ACK.PSE | — | — | Файла нет. | —"_s);
    m_page->setFileComplaints(8, {});
    QVERIFY(table->isHidden());
}

void TestWeatherPage::drawsOnlyWhenSeen()
{
    const auto *model = find<TableView>("weatherTable")->model();
    const QSignalSpy resets(model, &QAbstractItemModel::modelReset);
    m_registry->update({test::weatherReading(7, test::sampleWeather(), std::chrono::steady_clock::now())});
    QTest::qWait(400);
    QCOMPARE(resets.size(), 0);
    m_page->show();
    QCOMPARE(resets.size(), 1);
    const QSignalSpy changes(model, &QAbstractItemModel::dataChanged);
    Weather weather = test::sampleWeather();
    for (int i = 0; i < 100; ++i) {
        weather.parameters[0].mean = i;
        m_registry->update({test::weatherReading(7, weather, std::chrono::steady_clock::now())});
    }
    QCOMPARE(changes.size(), 0); // a hundred readings are drawn once
    QTRY_COMPARE(changes.size(), 1);
    m_page->hide();
    m_registry->update({test::weatherReading(7, test::sampleWeather(), std::chrono::steady_clock::now())});
    QTest::qWait(400);
    QCOMPARE(changes.size(), 1);
}

void TestWeatherPage::isCopied()
{
    answer(test::sampleWeather());
    auto *table = find<TableView>("weatherTable");
    table->selectRow(5);
    QCOMPARE(table->selectionAsText(), u"Скорость ветра\tM1\tм/с\t4.1\t3.9\t2.0\t6.8\t7.3\t0.82\t—\t—"_s);
    QCOMPARE(m_page->focusProxy(), table);
    answer(test::sampleWeather()); // a reading takes the selection of nobody
    QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
}

void TestWeatherPage::fitsASmallWindow()
{
    const QSize least = m_page->minimumSizeHint();
    QVERIFY2(least.width() <= 900, qPrintable(QString::number(least.width())));
    QVERIFY2(least.height() <= 560, qPrintable(QString::number(least.height())));
}

void TestWeatherPage::modelsKeepTheRules()
{
    for (const char *name : {"weatherTable", "rainTable", "windTable", "stationFilesTable"}) {
        new QAbstractItemModelTester(
            find<TableView>(name)->model(), QAbstractItemModelTester::FailureReportingMode::QtTest, m_page.get());
    }
    Weather weather = test::sampleWeather();
    weather.events = {{true, 10}};
    answer(weather);
    weather.parameters.removeLast();
    weather.events.clear();
    answer(weather);
    answer(Weather());
    QCOMPARE(find<TableView>("weatherTable")->model()->rowCount(), 0);
}

/// «Скорость ветра U, V» and the parameters on the page <Датчик>; wind and temperature in the tool tip of the table.
void TestWeatherPage::sensorPageAndTable()
{
    const auto rows = [this] {
        const auto index = static_cast<std::size_t>(m_registry->indexOf(7));
        return sensorProperties(m_registry->sensors()[index], LineState::Open, std::chrono::steady_clock::now());
    };
    const qsizetype before = rows().size();
    QCOMPARE(rows().at(5).value, u"—"_s);
    answer(test::sampleWeather());
    QCOMPARE(rows().size(), before + 7);
    QCOMPARE(rows().at(5).name, u"Скорость ветра U, V, м/с"_s);
    QCOMPARE(rows().at(5).value, u"+2.9 +2.9"_s);
    QCOMPARE(rows().at(before + 1).name, u"Температура T1, °C"_s);
    QCOMPARE(rows().at(before + 1).value, u"-3.25 (-3.20 | -3.50 … -3.00)"_s);
    QCOMPARE(rows().last().name, u"Цифровые входы"_s);
    QCOMPARE(rows().last().value, u"0x80000011 (0, 4, 31)"_s);
    SensorModel model(*m_registry);
    const int row = model.rowOf(m_registry->indexOf(7));
    QCOMPARE(model.index(row, SensorModel::Sensor).data().toString(), u"7 МК-14 [Крыша] [1]"_s);
    QVERIFY(model.index(row, SensorModel::Sensor)
                .data(Qt::ToolTipRole)
                .toString()
                .endsWith(u"\nветер 4.1 м/с, 225° ЮЗ; температура -3.25 °C"_s));
    Reading lost = test::weatherReading(7, test::sampleWeather(), std::chrono::steady_clock::now());
    lost.status = 0x3700;
    m_registry->update({lost});
    QCOMPARE(rows().size(), before + 7);
    QCOMPARE(rows().at(5).value, u"—"_s);
    QCOMPARE(rows().at(before + 1).value, u"—"_s);
}

QTEST_MAIN(TestWeatherPage)

#include "tst_weatherpage.moc"
