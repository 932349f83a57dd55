#include "core/devices/and3/and3service.h"
#include "tests/core/devices/and3frames.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::and3;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// Frames of spec/and3.md; their check sums go bit by bit, not through the codec.
class TstAnd3Service : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reads();
    void firmwareIsSilent();
    void readsAgain();
    void nobodyThere();
    void keepsSilence();
    void probes();
    void impossibleAddress();
    void storesAddress();
    void takenAddress();
    void bytesMeanSomethingElse();
    void anotherByteChanged();
    void answerLikeAnEcho();
    void nothingWasStored();
    void storedAtTheSecondTry();
    void lateAnswerProvesNothing();
    void lineIsLost_data();
    void lineIsLost();
    void sensorFallsSilent_data();
    void sensorFallsSilent();
    void resets_data();
    void resets();
    void resetOfNobody();
};

namespace {

const Service service{Timing()};

const QByteArray silence;
const QByteArray ask1 = hex("01 C9 00 00 12 4A");
const QByteArray ask2 = hex("02 C9 00 00 CE D1");
const QByteArray askFirmware = hex("01 24 04 00 B6 64");
const QByteArray askCurrent = hex("01 DD 00 00 B1 D5");
const QByteArray copy = sealed({1, 225, 0, 0});
const QByteArray copied = sealed({1, 225});
const QByteArray askTemporary = sealed({1, 221, 1, 0});
const QByteArray askStored = sealed({1, 221, 2, 0});
const QByteArray setByte = sealed({1, 224, 4, 2});
const QByteArray byteSet = sealed({1, 224});
const QByteArray store = sealed({1, 220, 66, 99});
const QByteArray stored = sealed({1, 220, 0, 0});
const QByteArray reset = hex("01 63 42 63 24 07");

QByteArray values(int address = 1)
{
    return complexReadAnswer(1000, 0x240F, 0xCC00, address);
}

/// Byte 4 the address, byte 5 the inner transducer's, the rest numbered.
QByteArray configuration(int address, int lastByte = 31)
{
    QByteArray frame;
    addWord(frame, 1, 1);
    addWord(frame, 221, 1);
    for (int i = 0; i < 31; ++i) {
        addWord(frame, static_cast<quint32>(i == 4 ? address : i == 5 ? 1 : i), 1);
    }
    addWord(frame, static_cast<quint32>(lastByte), 1);
    return sealed(frame);
}

void expectThrice(FakeLine &line, const QByteArray &request, const QByteArray &answer)
{
    line.expect(request, answer).expect(request, answer).expect(request, answer);
}

/// Everything up to the order to store.
FakeLine &expectPrepared(FakeLine &line)
{
    expectThrice(line, ask2, silence);
    line.expect(copy, copied).expect(ask1, values()).expect(askTemporary, configuration(1));
    return line.expect(setByte, byteSet).expect(askTemporary, configuration(2));
}

bool isClean(const FakeLine &line)
{
    return line.isDone() && line.complaints().isEmpty();
}

} // namespace

void TstAnd3Service::reads()
{
    FakeLine line;
    line.expect(ask1, values()).expect(askFirmware, sealed({1, 36, 12, 3, 2, 0})).expect(askCurrent, configuration(1));
    const auto settings = service.read(line, 1);
    QVERIFY(settings);
    QCOMPARE(settings->address, 1);
    QVERIFY(settings->firmware == (Firmware{.version = 2, .subVersion = 3, .build = 12}));
    QCOMPARE(int(settings->configuration[addressIndex]), 1);
    QCOMPARE(int(settings->configuration[30]), 30);
    QCOMPARE(settings->values.temperature, 20.0);
    QCOMPARE(settings->values.tilt, (Tilt{10, -10}));
    QVERIFY(isClean(line));
}

void TstAnd3Service::firmwareIsSilent()
{
    FakeLine line;
    line.expect(ask1, values());
    expectThrice(line, askFirmware, silence);
    line.expect(askCurrent, configuration(1));
    const auto settings = service.read(line, 1);
    QVERIFY(settings);
    QVERIFY(!settings->firmware);
    QVERIFY(isClean(line));
}

void TstAnd3Service::readsAgain()
{
    FakeLine line;
    QByteArray damaged = values();
    damaged[6] = static_cast<char>(damaged.at(6) ^ 1);
    line.expect(ask1, damaged).expect(ask1, silence).expect(ask1, values());
    const auto read = service.readValues(line, 1);
    QVERIFY(read);
    QCOMPARE(read->temperature, 20.0);
    QVERIFY(isClean(line));
}

void TstAnd3Service::nobodyThere()
{
    FakeLine line;
    expectThrice(line, ask1, silence);
    QVERIFY(service.read(line, 1).fault() == Fault::Timeout);
    QVERIFY(isClean(line));
    QVERIFY(line.elapsed() <= 650ms);
}

/// Ten milliseconds at least, also where the ini wants less.
void TstAnd3Service::keepsSilence()
{
    for (const auto wanted : {0ms, 16ms, 30ms}) {
        Timing timing;
        timing.addressChange = wanted;
        FakeLine line;
        expectPrepared(line).expect(store, stored).expect(askStored, configuration(2));
        QVERIFY(Service(timing).storeAddress(line, 1, 2).result);
        const auto times = line.requestTimes();
        for (qsizetype i = 4; i < times.size(); ++i) { // answered at once since the copy
            QVERIFY(times.at(i) - times.at(i - 1) >= std::max(wanted, 10ms));
        }
    }
}

void TstAnd3Service::probes()
{
    FakeLine line;
    QByteArray damaged = values();
    damaged[10] = static_cast<char>(damaged.at(10) ^ 0x40);
    line.expect(ask1, values());
    QVERIFY(service.probe(line, 1));
    line.expect(ask1, silence);
    QVERIFY(service.probe(line, 1).fault() == Fault::Timeout);
    line.expect(ask1, damaged).expect(ask1, values());
    QVERIFY(service.probe(line, 1));
    expectThrice(line, ask1, damaged);
    QVERIFY(service.probe(line, 1).fault() == Fault::Checksum);
    QVERIFY(isClean(line));
}

void TstAnd3Service::impossibleAddress()
{
    FakeLine line;
    for (const int address : {-1, 0, 256, 257}) {
        QVERIFY(service.probe(line, address).fault() == Fault::Refused);
        QVERIFY(service.read(line, address).fault() == Fault::Refused);
        QVERIFY(service.reset(line, address).fault() == Fault::Refused);
        QVERIFY(service.storeAddress(line, address, 2).result.fault() == Fault::Refused);
        QVERIFY(service.storeAddress(line, 1, address).result.fault() == Fault::Refused);
    }
    QVERIFY(line.requestTimes().isEmpty());
}

void TstAnd3Service::storesAddress()
{
    FakeLine line;
    expectPrepared(line).expect(store, stored).expect(askStored, configuration(2));
    const auto change = service.storeAddress(line, 1, 2);
    QVERIFY(change.result);
    QVERIFY(change.step == AddressStep::Done);
    QVERIFY(isClean(line));
}

void TstAnd3Service::takenAddress()
{
    FakeLine line;
    line.expect(ask2, silence).expect(ask2, values(2));
    const auto change = service.storeAddress(line, 1, 2);
    QVERIFY(change.result.fault() == Fault::Refused);
    QVERIFY(change.step == AddressStep::Probe);
    QVERIFY(isClean(line));
}

/// The document contradicts itself about which byte is the address: byte 4 has to hold the one that is in force.
void TstAnd3Service::bytesMeanSomethingElse()
{
    FakeLine line;
    expectThrice(line, ask2, silence);
    line.expect(copy, copied).expect(ask1, values());
    expectThrice(line, askTemporary, configuration(9));
    const auto change = service.storeAddress(line, 1, 2);
    QVERIFY(change.result.fault() == Fault::BadReply);
    QVERIFY(change.step == AddressStep::Check);
    QVERIFY(isClean(line));
}

void TstAnd3Service::anotherByteChanged()
{
    FakeLine line;
    expectThrice(line, ask2, silence);
    line.expect(copy, copied).expect(ask1, values()).expect(askTemporary, configuration(1)).expect(setByte, byteSet);
    expectThrice(line, askTemporary, configuration(2, 77));
    const auto change = service.storeAddress(line, 1, 2);
    QVERIFY(change.result.fault() == Fault::BadReply);
    QVERIFY(change.step == AddressStep::Verify);
    QVERIFY(isClean(line));
}

/// An answer that mirrors its request cannot be told from the echo of an adapter.
void TstAnd3Service::answerLikeAnEcho()
{
    FakeLine line;
    expectPrepared(line).expect(store, store).expect(askStored, configuration(2));
    QVERIFY(service.storeAddress(line, 1, 2).step == AddressStep::Done);
    QVERIFY(isClean(line));
}

void TstAnd3Service::nothingWasStored()
{
    FakeLine line;
    expectPrepared(line);
    for (int i = 0; i < 3; ++i) {
        line.expect(store, silence);
        expectThrice(line, askStored, configuration(1));
    }
    const auto change = service.storeAddress(line, 1, 2);
    QVERIFY(change.result.fault() == Fault::BadReply);
    QVERIFY(change.step == AddressStep::VerifyStored);
    QVERIFY(isClean(line));
}

void TstAnd3Service::storedAtTheSecondTry()
{
    FakeLine line;
    expectPrepared(line).expect(store, silence);
    expectThrice(line, askStored, configuration(1));
    line.expect(store, stored).expect(askStored, configuration(2));
    QVERIFY(service.storeAddress(line, 1, 2).step == AddressStep::Done);
    QVERIFY(isClean(line));
}

/// The answer about the temporary configuration comes when the stored one was asked for, and says the same.
void TstAnd3Service::lateAnswerProvesNothing()
{
    FakeLine line;
    expectThrice(line, ask2, silence);
    line.expect(copy, copied).expect(ask1, values()).expect(askTemporary, configuration(1)).expect(setByte, byteSet);
    line.expect(askTemporary, silence).expect(askTemporary, configuration(2));
    line.expect(store, silence).expect(askStored, configuration(2)); // late
    expectThrice(line, askStored, configuration(1));
    line.expect(store, stored).expect(askStored, configuration(2)).expect(askStored, configuration(2));
    QVERIFY(service.storeAddress(line, 1, 2).step == AddressStep::Done);
    QVERIFY(isClean(line));
}

namespace {

struct Turn
{
    QByteArray request;
    QByteArray answer;
    AddressStep step;
};

/// Every exchange of a change of address after the probe.
const QList<Turn> turns{
    {copy, copied, AddressStep::Copy},
    {ask1, values(), AddressStep::Check},
    {askTemporary, configuration(1), AddressStep::Check},
    {setByte, byteSet, AddressStep::Set},
    {askTemporary, configuration(2), AddressStep::Verify},
    {store, stored, AddressStep::Store},
    {askStored, configuration(2), AddressStep::VerifyStored}};

void eachTurn()
{
    QTest::addColumn<int>("turn");
    for (int turn = 0; turn < turns.size(); ++turn) {
        QTest::addRow("%d", turn) << turn;
    }
}

} // namespace

void TstAnd3Service::lineIsLost_data()
{
    eachTurn();
}

void TstAnd3Service::lineIsLost()
{
    QFETCH(int, turn);
    FakeLine line;
    expectThrice(line, ask2, silence);
    for (int i = 0; i < turn; ++i) {
        line.expect(turns.at(i).request, turns.at(i).answer);
    }
    line.vanishAfter(turns.at(turn).request);
    const auto change = service.storeAddress(line, 1, 2);
    QVERIFY(!change.result && change.result.fault() == Fault::Closed);
    QVERIFY(change.step == turns.at(turn).step);
    QVERIFY(isClean(line));
}

void TstAnd3Service::sensorFallsSilent_data()
{
    eachTurn();
}

void TstAnd3Service::sensorFallsSilent()
{
    QFETCH(int, turn);
    FakeLine line;
    expectThrice(line, ask2, silence);
    for (int i = 0; i < turn; ++i) {
        line.expect(turns.at(i).request, turns.at(i).answer);
    }
    if (turns.at(turn).step < AddressStep::Store) {
        expectThrice(line, turns.at(turn).request, silence);
    } else {
        for (int i = 0; i < 3; ++i) {
            if (turns.at(turn).step == AddressStep::Store || i > 0) {
                line.expect(store, silence);
            }
            expectThrice(line, askStored, silence);
        }
    }
    const auto change = service.storeAddress(line, 1, 2);
    QVERIFY(!change.result && change.result.fault() == Fault::Timeout);
    QVERIFY(change.step == std::max(turns.at(turn).step, turn > 4 ? AddressStep::VerifyStored : AddressStep::Copy));
    QVERIFY(isClean(line));
    QVERIFY(line.elapsed() <= line.requestTimes().size() * 220ms);
}

void TstAnd3Service::resets_data()
{
    QTest::addColumn<QByteArrayList>("answers");
    QTest::newRow("two bytes of data") << QByteArrayList{sealed({1, 99, 0, 0})};
    QTest::newRow("no data") << QByteArrayList{sealed({1, 99})};
    QTest::newRow("like an echo") << QByteArrayList{reset, reset, reset};
    QTest::newRow("silent") << QByteArrayList{silence, silence, silence};
}

void TstAnd3Service::resets()
{
    QFETCH(QByteArrayList, answers);
    FakeLine line;
    line.expect(ask1, values());
    for (const QByteArray &answer : std::as_const(answers)) {
        line.expect(reset, answer);
    }
    QVERIFY(service.reset(line, 1));
    QVERIFY(isClean(line));
}

void TstAnd3Service::resetOfNobody()
{
    FakeLine line;
    expectThrice(line, ask1, silence);
    QVERIFY(service.reset(line, 1).fault() == Fault::Timeout);
    line.expect(ask1, values()).vanishAfter(reset);
    QVERIFY(service.reset(line, 1).fault() == Fault::Closed);
    QVERIFY(isClean(line));
}

QTEST_GUILESS_MAIN(TstAnd3Service)
#include "tst_and3service.moc"
