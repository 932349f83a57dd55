#include "core/devices/lvims/lvimsregisters.h"

#include <QTest>

#include <algorithm>
#include <span>
#include <vector>

using namespace gorizont;
using namespace gorizont::lvims;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

/// A line of the manual: address, name, type, access.
struct Line
{
    int address;
    std::string_view name;
    std::string_view type;
    std::string_view access;
};

/// Section 2.2, typed from the manual with its sums; what it prints as address + I stands here for I = 0.
constexpr Line modulePages[] = {
    {1, "DEVNAME", "STR32", "R"},
    {17, "SERIAL", "STR32", "R"},
    {33, "FWVER", "STR32", "R"},
    {49, "BRD_REV", "STR16", "R"},
    {97, "DEVMODE", "U16", "R"},
    {98, "LAST_WR_ERROR", "U16", "R"},
    {99, "LAST_CHECK_SETTINGS_ERR", "U32", "R"},
    {1024, "ST_CH_UP_ID", "U16", "R"},
    {1028, "ST_WF_UP_ID", "U16", "R"},
    {1032, "ST_WF_RDY_CNT", "U16", "R"},
    {1036, "ST_SPEC_5000_UP_ID", "U16", "R"},
    {1040, "ST_SPEC_5000_RDY_CNT", "U16", "R"},
    {1044, "ST_SPEC_200_UP_ID", "U16", "R"},
    {1048, "ST_SPEC_200_RDY_CNT", "U16", "R"},
    {1052, "ST_SET_UP_ID", "U16", "R"},
    {1053, "OUTSYS_UP_ID", "U16", "R"},
    {1280, "CH_STATE", "CHST", "R"},
    {1632, "RELE_STATE", "U32", "R"},
    {36864 + 0, "WF_RD_CH", "U16", "RW"},
    {36864 + 1, "WF_RD_ID", "U16", "RW"},
    {36864 + 2, "WF_RD_OFFS", "U32", "RW"},
    {36864 + 4, "WF_RD_DATA", "U32", "RW"},
    {37120 + 0, "WF_INFO_CH", "U16", "R"},
    {37120 + 1, "WF_INFO_ID", "U16", "R"},
    {37120 + 2, "WF_INFO_SIZE", "U32", "R"},
    {37120 + 4, "WF_INFO_FREQ", "float", "R"},
    {37120 + 6, "WF_INFO_E_K", "float", "R"},
    {37120 + 8, "WF_INFO_E_B", "float", "R"},
    {37120 + 10, "WF_INFO_P_K", "float", "R"},
    {37120 + 12, "WF_INFO_P_B", "float", "R"},
    {37120 + 36, "WF_INFO_CHST", "CHST", "R"},
    {37376 + 0, "SPECTR_RD_CH", "U16", "RW"},
    {37376 + 1, "SPECTR_RD_TYPE", "U16", "RW"},
    {37376 + 2, "SPECTR_RD_OFFS", "U32", "RW"},
    {37376 + 4, "SPECTR_RD_DATA", "U32", "RW"},
    {37632 + 0, "SPECTR_INFO_CH", "U16", "R"},
    {37632 + 1, "SPECTR_INFO_TYPE", "U16", "R"},
    {37632 + 2, "SPECTR_INFO_SIZE", "U32", "R"},
    {37632 + 4, "SPECTR_INFO_DECI_FREQ", "float", "R"},
    {37632 + 6, "SPECTR_INFO_E_K", "float", "R"},
    {37632 + 8, "SPECTR_INFO_E_B", "float", "R"},
    {37632 + 10, "SPECTR_INFO_P_K", "float", "R"},
    {37632 + 12, "SPECTR_INFO_P_B", "float", "R"},
    {37632 + 14, "SPECTR_INFO_WND_SUM", "float", "R"},
    {37632 + 16, "SPECTR_INFO_WND_SUM2", "float", "R"},
    {40960, "CMD_INPUT", "U16", "W"},
    {45056, "CUR_SETTINGS", "SET", "R"},
    {53248, "MUT_SETTINGS", "SET", "RW"},
    {61440, "SETTINGS_CMD", "U32", "W"},
    {65280, "REBOOT_CMD", "U16[4]", "W"},
};

/// Section 2.3, M = 0; it has no column of access, the whole set is read.
constexpr Line channelPages[] = {
    {0, "CH_STATUS", "U16", "R"},     {8, "MEAS_TYPE", "U16", "R"},      {9, "MEAS_ST_FLAGS", "U16", "R"},
    {10, "MEAS_VALUE", "float", "R"}, {12, "MEAS_FS_PERC", "U16S", "R"}, {13, "MEAS_BASELINE_PERC", "U16S", "R"},
};

/// Section 2.4, I = M = 0.
constexpr Line settingPages[] = {
    {0, "CUSTOM_NAME", "STR64", "RW"}, {32, "IP_ADDR", "IPAddr", "RW"},     {34, "IP_MASK", "IPAddr", "RW"},
    {36, "IP_GATE", "IPAddr", "RW"},   {112, "CH_EN_MASK", "U16", "RW"},    {113, "CH_SENS_PWR", "U16", "RW"},
    {114, "WF_ACQ_TIME", "U16", "RW"}, {142, "CH_SENSOR_K", "float", "RW"}, {144, "CH_SENSOR_B", "float", "RW"},
    {208, "MEAS_TYPE", "U16", "RW"},   {230, "MEAS_IIR_HP", "IIR", "RW"},   {234, "MEAS_IIR_LP", "IIR", "RW"},
};

/// Section 2.5.
constexpr Line filterPages[] = {{0, "IIR_EN", "U16", "RW"}, {1, "IIR_FC_L", "U16", "RW"}, {2, "IIR_FC_H", "U16", "RW"}};

QString text(std::string_view view)
{
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

/// As the manual prints it.
QString typeOf(const Register &entry)
{
    switch (entry.type) {
    case RegisterType::U16: return u"U16"_s;
    case RegisterType::U16S: return u"U16S"_s;
    case RegisterType::U32: return u"U32"_s;
    case RegisterType::Float: return u"float"_s;
    case RegisterType::Text: return u"STR%1"_s.arg(2 * entry.size);
    case RegisterType::IpAddress: return u"IPAddr"_s;
    case RegisterType::Words: return u"U16[%1]"_s.arg(entry.size);
    case RegisterType::ChannelState: return u"CHST"_s;
    case RegisterType::Settings: return u"SET"_s;
    case RegisterType::Filter: return u"IIR"_s;
    }
    return {};
}

/// Section 2.1; sections 2.3 to 2.5 for the sets.
int sizeOf(const QString &type)
{
    static const QHash<QString, int> sizes{{u"U16"_s, 1},   {u"U16S"_s, 1},   {u"U32"_s, 2},    {u"float"_s, 2},
                                           {u"STR16"_s, 8}, {u"STR32"_s, 16}, {u"STR64"_s, 32}, {u"IPAddr"_s, 2},
                                           {u"CHST"_s, 88}, {u"SET"_s, 7456}, {u"IIR"_s, 4},    {u"U16[4]"_s, 4}};
    return sizes.value(type);
}

void compare(std::span<const Register> table, std::span<const Line> pages)
{
    QCOMPARE(table.size(), pages.size());
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const Register &row = table[i];
        const Line &line = pages[i];
        QCOMPARE(text(row.name), text(line.name));
        QCOMPARE(int(row.address), line.address);
        QCOMPARE(typeOf(row), text(line.type));
        QCOMPARE(int(row.size), sizeOf(text(line.type)));
        const QString access = row.access == Access::Read ? u"R"_s : row.access == Access::Write ? u"W"_s : u"RW"_s;
        QCOMPARE(access, text(line.access));
        QVERIFY2(!row.meaning.empty(), row.name.data());
    }
}

/// First and one behind the last register of every occurrence.
std::vector<std::pair<int, int>> spans(std::span<const Register> table)
{
    std::vector<std::pair<int, int>> all;
    for (const Register &entry : table) {
        for (int channel = 0; channel < (entry.channelStep ? channelCount : 1); ++channel) {
            for (int item = 0; item < entry.items; ++item) {
                all.emplace_back(entry.at(channel, item), entry.at(channel, item) + entry.size);
            }
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

void nothingOverlaps(std::span<const Register> table, int end)
{
    int free = 0;
    for (const auto &[first, last] : spans(table)) {
        QVERIFY2(first >= free, qPrintable(u"register %1 is given twice"_s.arg(first)));
        free = last;
    }
    QVERIFY(free <= end);
}

} // namespace

/// The table against manual 003: what stands on the right here was typed from it.
class TstLVimsRegisters : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theModule() { compare(moduleRegisters, modulePages); }
    void aChannel() { compare(channelRegisters, channelPages); }
    void theSettings() { compare(settingRegisters, settingPages); }
    void aFilter() { compare(filterRegisters, filterPages); }

    void repeatedOnes_data()
    {
        QTest::addColumn<int>("address");
        QTest::addColumn<int>("printed");
        const auto row = [](const char *name, int address, int printed) { QTest::newRow(name) << address << printed; };
        row("ST_WF_RDY_CNT, I = 3", moduleRegister("ST_WF_RDY_CNT").at(3), 1032 + 3);
        row("ST_SPEC_200_RDY_CNT, I = 2", moduleRegister("ST_SPEC_200_RDY_CNT").at(2), 1048 + 2);
        row("CH_STATE, I = 3", moduleRegister("CH_STATE").at(3), 1280 + 88 * 3);
        row("WF_RD_DATA, S = 61", moduleRegister("WF_RD_DATA").at(0, 61), 36864 + 4 + 2 * 61);
        row("SPECTR_RD_DATA, S = 61", moduleRegister("SPECTR_RD_DATA").at(0, 61), 37376 + 4 + 2 * 61);
        row("MEAS_VALUE, M = 7", channelRegister("MEAS_VALUE").at(0, 7), 10 + 10 * 7);
        row("MEAS_BASELINE_PERC, M = 1", channelRegister("MEAS_BASELINE_PERC").at(0, 1), 13 + 10);
        row("CH_SENSOR_B, I = 2", settingRegister("CH_SENSOR_B").at(2), 144 + 386 * 2);
        row("MEAS_TYPE, I = 3, M = 7", settingRegister("MEAS_TYPE").at(3, 7), 208 + 386 * 3 + 40 * 7);
        row("MEAS_IIR_LP, I = 1, M = 2", settingRegister("MEAS_IIR_LP").at(1, 2), 234 + 386 + 40 * 2);
    }

    void repeatedOnes()
    {
        QFETCH(int, address);
        QTEST(address, "printed");
    }

    /// The status block is one request, 1024…1053; the echo with 60 samples and the information with CHST fit into one each.
    void whatIsReadAtOnce()
    {
        QCOMPARE(moduleRegister("OUTSYS_UP_ID").address - moduleRegister("ST_CH_UP_ID").address + 1, 30);
        QCOMPARE(moduleRegister("WF_INFO_CHST").address + channelStateSize - moduleRegister("WF_INFO_CH").address, 124);
        QCOMPARE(moduleRegister("WF_RD_DATA").at(0, 60) - moduleRegister("WF_RD_CH").address, 124);
    }

    void nothingLiesInTwoPlaces()
    {
        nothingOverlaps(moduleRegisters, 65536);
        nothingOverlaps(channelRegisters, channelStateSize);
        nothingOverlaps(settingRegisters, settingsSize);
        nothingOverlaps(filterRegisters, 4);
    }
};

QTEST_APPLESS_MAIN(TstLVimsRegisters)
#include "tst_lvimsregisters.moc"
