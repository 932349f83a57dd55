#include "core/config/inifile.h"
#include "translations/translation.h"
#include "ui/models/propertymodel.h"
#include "ui/models/settingsproperties.h"
#include "ui/models/stateproperties.h"

#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

QString text(const Properties &properties)
{
    QStringList lines;
    for (const Property &property : properties) {
        lines += property.isSection ? property.name : property.name + QStringLiteral(" | ") + property.value;
    }
    return lines.join(u'\n');
}

} // namespace

class TestProperties : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The words are those of manual 000, sections 4.4 – 4.8.
    void initTestCase() { QVERIFY(installTranslation(QStringLiteral("ru"))); }

    void port()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        LineStatus status = test::openLine(1, now - 3600s);
        status.pollingAt = now - 238s;
        status.bytesSent = 10;
        status.bytesReceived = 20;
        status.failedOpens = 1;
        status.writeErrors = 2;
        status.readErrors = 3;
        status.crcErrors = 4;
        status.lastErrorCode = 12;
        status.lastError = QStringLiteral("timed out");
        registry.updateLine(status);
        QCOMPARE(
            text(portProperties(registry.lines().front(), now)),
            QStringLiteral("Комментарий | Moxa UPort 1151\n"
                           "Состояние | Открыт, идёт опрос\n"
                           "Время опроса | 0:03:58\n"
                           "Время после открытия | 1:00:00\n"
                           "Отправлено байт | 10\n"
                           "Принято байт | 20\n"
                           "Попыток открытия | 1\n"
                           "Ошибок записи | 2\n"
                           "Ошибок чтения | 3\n"
                           "Ошибок CRC | 4\n"
                           "Код последней ошибки | 12 (timed out)"));
    }

    void sensor()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        registry.update({test::sampleReading(now)});
        registry.setPacketsSaved(1, 179);
        QCOMPARE(
            text(sensorProperties(registry.sensors().front(), LineState::Open, now)),
            QStringLiteral("Комментарий | АН1 (АН-Д3, TMP05, подогрев)\n"
                           "Состояние | Отвечает\n"
                           "Углы Мх, Му, град. (угл. сек.) | -1.000 +0.756 (-3599.5 +2720.5)\n"
                           "Ускорения Ах, Ау, мм/с² | 7.67 270.0 (2.19|0.00 2.19) 179:179 (5728) 179\n"
                           "Температура Т, град. | 21.38\n"
                           "Скорость ветра U, V, м/с | —\n"
                           "Термостат, % (об./с) | 45.3 (41.0)\n"
                           "Слово состояния | 0010 0100 0000 1111 : 1100 1100 0000 0000\n"
                           "Период опроса, с | 1.002|0.031|00:00\n"
                           "Ошибок чтения | 3\n"
                           "Ошибок CRC | 2\n"
                           "Версия ПО | —\n"
                           "Системный такт | —\n"
                           "Мощность нагревателя | —\n"
                           "Мощность вентилятора | —\n"
                           "Адрес и команда преобразователя | —\n"
                           "Время ответа преобразователя | —"));
    }

    /// CanInfo=1: what comes stands below the rows of the manual; a type that is not asked has no such rows.
    void sensorThatSaysSomethingOfItself()
    {
        SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        DeviceInformation information;
        information.number = 1;
        information.firmware = QStringLiteral("2.3.12");
        information.systemClock = 40'000'000;
        information.heaterPower = 452;
        information.innerTransducer = 513;
        information.responseTime = 250;
        registry.setInformation(information);
        const SteadyTime now = std::chrono::steady_clock::now();
        QCOMPARE(
            text(sensorProperties(registry.sensors().front(), LineState::Open, now).mid(11)),
            QStringLiteral("Версия ПО | 2.3.12\n"
                           "Системный такт | 40000000\n"
                           "Мощность нагревателя | 452\n"
                           "Мощность вентилятора | —\n"
                           "Адрес и команда преобразователя | 513\n"
                           "Время ответа преобразователя | 250"));
        QCOMPARE(sensorProperties(registry.sensors()[1], LineState::Open, now).size(), 11);
    }

    void sensorWithoutAnswer()
    {
        const SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        const Properties rows =
            sensorProperties(registry.sensors().front(), LineState::Opening, std::chrono::steady_clock::now());
        QCOMPARE(rows.size(), 17);
        for (int row = 2; row <= 8; ++row) {
            QCOMPARE(rows.at(row).value, QStringLiteral("—"));
        }
    }

    void everyRowExplainsItself()
    {
        const SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        const SteadyTime now = std::chrono::steady_clock::now();
        ServerConfig config = test::sampleConfig();
        config.mqtt.host = QStringLiteral("broker.example");
        config.metrics.port = 9100;
        config.chains = {{3, {}, {{2, 3.6}}}};
        for (const Property &property : portProperties(registry.lines().front(), now)
                 + sensorProperties(registry.sensors().front(), LineState::Open, now) + serverSettings(config)
                 + lineSettings(config, config.lines.first())
                 + sensorSettings(config, config.lines.first().sensors.first())) {
            QVERIFY2(property.isSection || !property.note.isEmpty(), qPrintable(property.name));
            QVERIFY2(property.isSection || !property.value.isEmpty(), qPrintable(property.name));
        }
    }

    void sensorToolTips()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        Reading reading = test::sampleReading(now);
        reading.status = 0x0220;
        registry.update({reading, test::tiltReading(2, 0, 0, now)});
        PropertyModel model(false);
        model.setProperties(sensorProperties(registry.sensors().front(), LineState::Open, now));
        const auto toolTip = [&model](int row) {
            return model.index(row, PropertyModel::Name).data(Qt::ToolTipRole).toString();
        };
        QVERIFY(toolTip(3).startsWith(QStringLiteral("максимум по X -0.00, по Y -7.67 мм/с²\n")));
        QCOMPARE(
            toolTip(7),
            QStringLiteral("флаги состояния : флаги режима работы, как их передаёт датчик\n"
                           "бит 13: термостат включен\nбит 10: ошибка вентилятора\nбит 3: данные вентилятора готовы\n"
                           "бит 2: температура готова\nбит 1: углы готовы\nбит 0: перезагрузка подтверждена\n\n"
                           "слово состояния программы: 0 0010 0010 0000\nкод 0: Нет ошибок\n"
                           "бит 9: результаты измерения температуры не достоверны или не готовы\n"
                           "бит 5: произошла перезагрузка микроконтроллера"));
        // ИН-Д3 has no raw word: a dash, and the computed word in the tool tip
        model.setProperties(sensorProperties(registry.sensors().at(1), LineState::Open, now));
        QCOMPARE(model.index(7, PropertyModel::Value).data().toString(), QStringLiteral("—"));
        QVERIFY(toolTip(7).contains(QStringLiteral("слово состояния программы: 0 0011 0000 0000")));
    }

    /// State by a shape as well as by words.
    void stateHasAnIcon()
    {
        const SensorRegistry registry(test::sampleConfig().lines, StatusRules());
        const SteadyTime now = std::chrono::steady_clock::now();
        PropertyModel model(false);
        model.setProperties(portProperties(registry.lines().back(), now));
        QVERIFY(!model.index(1, PropertyModel::Value).data(Qt::DecorationRole).isNull());
        QVERIFY(model.index(0, PropertyModel::Value).data(Qt::DecorationRole).isNull());
        QCOMPARE(portProperties(registry.lines().back(), now).at(1).health, std::optional(Health::Off));
        QCOMPARE(
            sensorProperties(registry.sensors().back(), LineState::Open, now).at(1).health, std::optional(Health::Off));
    }

    /// The first seven sections are those of the manual, in its order; what it does not list follows.
    void serverSettingsInTheOrderOfTheManual()
    {
        QCOMPARE(
            text(serverSettings(test::sampleConfig())),
            QStringLiteral(
                "[Сервер]\nКомментарий | Высотное здание\nIP порт | 502\n"
                "[Timers]\nTmUpdateInt | 100 мс\nTmRun | 1000 мс\nTmStart | 1000 мс\nTmSave | 1000 мс\n"
                "[Pauses]\nPPauseTick | 100 мс\nPReOpen | 5000 мс\nPClose | 5000 мс\nPExit | 1000 мс\n"
                "[Sleeps]\nSAdrChange | 16 мс\nSIdle | 1 мс\nSRError | 0 мс\nSCRCError | 600 мс\n"
                "[TimeOuts]\nTORCom | 200 мс\nTOWCom | 100 мс\nTORDat | 4000 мс\nTOWDat | 2000 мс\n"
                "[Errors]\nNumRErrSrs | 10\nNumCErrSrs | 10\n"
                "[Дополнительно]\nСохранять в файле | да\nОтображать записей | 60\nОчищать записей | 1\n"
                "Сворачивать в трей при запуске | нет\nПредупреждать при завершении работы | нет\n"
                "Разрешать запуск копии | нет\nРазрешить настройку | нет\nБуфер акселерометра | 8192 пакетов\n"
                "[Программа]\nЗаголовок окна | Gorizont Server (тест)\nЯзык | ru\nСерийный номер копии | —\n"
                "Портов в списке | 3\nЗапрашивать информацию | нет\nБуферов в файле | 1\n"
                "Ускорение св. падения, м/с² | 9.81347\nБиты статуса прежней программы | нет\n"
                "Интерфейс OPC DA | нет\n"
                "[Archive]\nВести архив | да\nХранится | в файле\nФайл | History/archive.sqlite\n"
                "Хранить показания | всегда\nХранить отсчёты | всегда\nХранить сводки | всегда\n"
                "Хранить события | всегда\nРазмер не более | любой\n"
                "[Modbus TCP]\nСервер Modbus TCP | да\nПорядок датчиков | по типам\nПервый регистр | 0\n"
                "Клиентов не более | 64\nОтключать молчащих клиентов | через 600 с\nАдрес сервера | все\n"
                "Разрешённые клиенты | все\n"
                "[ADC24 TCP]\nСервер ADC24 TCP | да\nIP порт ADC24 | 503\nОтдаваемый акселерометр | первый\n"
                "Отдаваемая ось | X\n[MQTT]\nБрокер | нет\n[Metrics]\nМетрики для Prometheus | выключены"));
    }

    void archiveOnAServerAndChains()
    {
        ServerConfig config = test::sampleConfig();
        config.archive.driver = ArchiveDriver::PostgreSql;
        config.archive.host = QStringLiteral("db.example");
        config.archive.database = QStringLiteral("sites");
        config.archive.keepRaw = 400;
        config.archive.mostSize = 20000;
        config.chains = {{3, QStringLiteral("Колонна"), {{2, 3.6}}}};
        const QString settings = text(serverSettings(config));
        QVERIFY(settings.contains(QStringLiteral("Хранится | PostgreSQL\nСервер | db.example\nПорт сервера | 5432\n"
                                                 "База данных | sites\n")));
        QVERIFY(settings.contains(QStringLiteral("Хранить показания | 400 сут\n")));
        QVERIFY(settings.contains(QStringLiteral("Размер не более | 20000 МБ\n")));
        QVERIFY(settings.contains(
            QStringLiteral("[Chain3]\nКомментарий | Колонна\nЗвено 1 | датчик 2, 3.6 м\n[Modbus TCP]")));
        config.archive.isOn = false;
        QVERIFY(text(serverSettings(config)).contains(QStringLiteral("Вести архив | нет\n[Chain3]")));
    }

    void brokerAndMetrics()
    {
        ServerConfig config = test::sampleConfig();
        config.mqtt.host = QStringLiteral("broker.example");
        config.mqtt.user = QStringLiteral("site7");
        config.mqtt.password = QStringLiteral("secret");
        config.metrics.port = 9100;
        const QString settings = text(serverSettings(config));
        QVERIFY(settings.contains(QStringLiteral("[MQTT]\nБрокер | broker.example\nПорт брокера | 1883\n")));
        QVERIFY(settings.contains(QStringLiteral("Пользователь | site7\n")));
        QVERIFY(settings.contains(QStringLiteral("Очередь не более | 64 МиБ\n")));
        QVERIFY(settings.contains(
            QStringLiteral("[Metrics]\nМетрики для Prometheus | порт 9100\nАдрес метрик | 127.0.0.1")));
        QVERIFY(!settings.contains(QStringLiteral("secret")));
    }

    void gatewaysOfOpc()
    {
        ServerConfig config = test::sampleConfig();
        QVERIFY(!text(serverSettings(config)).contains(QStringLiteral("[OPC]")));
        config.servesOpc = true;
        config.opc.port = 50001;
        const QString settings = text(serverSettings(config, 2));
        QVERIFY(settings.contains(QStringLiteral("Интерфейс OPC DA | да\n")));
        QVERIFY(settings.endsWith(QStringLiteral("\n[OPC]\nПорт для шлюзов OPC DA | 50001\nПодключено шлюзов | 2")));
    }

    /// The row shows the inverse of CanClose (spec/gorizont.md, section 1).
    void warningIsTheInverseOfCanClose()
    {
        ServerConfig config = test::sampleConfig();
        config.closesSilently = false;
        QVERIFY(text(serverSettings(config)).contains(QStringLiteral("Предупреждать при завершении работы | да")));
    }

    void portSettings()
    {
        const ServerConfig config = test::sampleConfig();
        QCOMPARE(
            text(lineSettings(config, config.lines.first())),
            QStringLiteral("[Порт]\nКомментарий | Moxa UPort 1151\nВключен | да\nНомер | COM4\n"
                           "BaudRate | 115200 бод\n"
                           "[Дополнительно]\nУстройство | —\nБиты данных | 8\nЧётность | нет\n"
                           "Стоповые биты | 1\nRS485 | нет\nДатчиков в списке | 2"));
    }

    void settingsOfASensor()
    {
        ServerConfig config = test::sampleConfig();
        config.lines.first().sensors.first().options.insert(QStringLiteral("verifycrc"), QStringLiteral("1"));
        QCOMPARE(
            text(sensorSettings(config, config.lines.first().sensors.first())),
            QStringLiteral("[Датчик]\nКомментарий | АН1 (АН-Д3, TMP05, подогрев)\nОпрос | да\n"
                           "Порядковый номер | 1\nАдрес на линии | 12\nСерийный номер | 804\n"
                           "[Юстировка]\nСмещение Mx, град. (угл. сек.) | +0.028 (+100.0)\n"
                           "Смещение My, град. (угл. сек.) | -1.000 (-3600.0)\nСмещение T, град. | +0.50\n"
                           "Инверсия оси Y | да\nПоворот оси X, град. | +90.000\n"
                           "Дата установки | 21.01.2017\nДата последней юстировки | 24.01.2017\n"
                           "Примечание | Линия 1, терминал 120 Ом\n"
                           "[Дополнительно]\nМесто установки | Этаж 2\nТип | АН-Д3\n"
                           "Измеряет | углы, температура, ускорения\nТермостат | да\nverifycrc1 | 1"));
        // a sensor without temperature has no offset of it
        QVERIFY(text(sensorSettings(config, config.lines.first().sensors.last()))
                    .contains(QStringLiteral("Смещение T, град. | —")));
    }

    /// From the file to the screen: what it gave, what is used instead, and where it stands.
    void replacedValuesAreMarked()
    {
        const ServerConfig config =
            readServerConfig(IniFile::fromBytes("[Common]\nNumOfPorts=1\n[Sleeps]\nSCRCErr=-5\n"
                                                "[ADC24]\nSensor=-1\n"
                                                "[Port1]\nNum=4\nOn=1\nNumOfSensors=1\nName1=AN-D3\nadr1=300\nOn1=1\n"))
                .config;
        QStringList marked;
        for (const Property &property :
             serverSettings(config) + sensorSettings(config, config.lines.first().sensors.first())) {
            if (!property.replaced.isEmpty()) {
                marked += property.key + u' ' + property.name + u' ' + property.replaced;
            }
        }
        QCOMPARE(
            marked,
            QStringList(
                {QStringLiteral("[Sleeps] SCRCError SCRCError в файле указано «-5», это значение использовать нельзя; "
                                "используется «600 мс»"),
                 QStringLiteral("[ADC24] Sensor Отдаваемый акселерометр в файле указано «-1», это значение "
                                "использовать нельзя; используется «первый»"),
                 QStringLiteral("[Port1] On1 Опрос в файле указано «1», это значение использовать нельзя; "
                                "используется «нет»"),
                 QStringLiteral("[Port1] adr1 Адрес на линии в файле указано «300», это значение использовать нельзя; "
                                "используется «1»")}));
    }

    void replacedValueIsSeen()
    {
        PropertyModel model(true);
        Property property{QStringLiteral("a"), QStringLiteral("1"), QStringLiteral("meaning")};
        property.key = QStringLiteral("[Timers] a");
        model.setProperties({property});
        const QModelIndex value = model.index(0, PropertyModel::Value);
        const QModelIndex note = model.index(0, PropertyModel::Note);
        QCOMPARE(note.data().toString(), QStringLiteral("meaning"));
        QCOMPARE(value.data(Qt::ToolTipRole).toString(), QStringLiteral("1\nmeaning\nв файле настроек: [Timers] a"));
        QVERIFY(value.data(Qt::DecorationRole).isNull());
        property.replaced = QStringLiteral("replaced");
        model.setProperties({property});
        QCOMPARE(note.data().toString(), QStringLiteral("replaced"));
        QCOMPARE(
            value.data(Qt::ToolTipRole).toString(),
            QStringLiteral("1\nreplaced\nmeaning\nв файле настроек: [Timers] a"));
        QVERIFY(!value.data(Qt::DecorationRole).isNull());
    }

    void modelAnnouncesOnlyWhatChanged()
    {
        PropertyModel model(false);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
        QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
        model.setProperties({{QStringLiteral("a"), QStringLiteral("1")}, {QStringLiteral("b"), QStringLiteral("2")}});
        QCOMPARE(reset.size(), 1);
        model.setProperties({{QStringLiteral("a"), QStringLiteral("1")}, {QStringLiteral("b"), QStringLiteral("3")}});
        QCOMPARE(reset.size(), 1);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(changed.at(0).at(0).toModelIndex(), model.index(1, PropertyModel::Value));
        QCOMPARE(test::modelText(model, true), QStringLiteral("Параметр | Значение\na | 1\nb | 3"));
    }
};

QTEST_MAIN(TestProperties)
#include "tst_properties.moc"
