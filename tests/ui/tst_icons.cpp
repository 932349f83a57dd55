#include "ui/models/icons.h"

#include <QGuiApplication>
#include <QIcon>
#include <QImage>
#include <QPalette>
#include <QtTest>

using namespace gorizont;

namespace {

const QList<Health> healths{Health::Off,     Health::Good,    Health::Unknown,
                            Health::Service, Health::Warning, Health::Error};
const QList<icons::Node> nodes{icons::Node::Server,       icons::Node::Port, icons::Node::Tilt,
                               icons::Node::Acceleration, icons::Node::Usm,  icons::Node::Vibration,
                               icons::Node::Weather,      icons::Node::None};

QImage render(const QIcon &icon, const QSize &size, double scale, QIcon::Mode mode = QIcon::Normal)
{
    return icon.pixmap(size, scale, mode).toImage().convertToFormat(QImage::Format_ARGB32);
}

/// Share of the pixels that are more than half covered, %.
double coverage(const QImage &image)
{
    int covered = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            covered += qAlpha(image.pixel(x, y)) > 127 ? 1 : 0;
        }
    }
    return 100.0 * covered / (image.width() * image.height());
}

/// Share of the pixels whose covering differs, %: the outline only, whatever the colours.
double outlineDifference(const QImage &a, const QImage &b)
{
    int different = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            different += std::abs(qAlpha(a.pixel(x, y)) - qAlpha(b.pixel(x, y))) > 64 ? 1 : 0;
        }
    }
    return 100.0 * different / (a.width() * a.height());
}

} // namespace

class TestIcons : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void statesAreDrawn_data() { sizes(); }
    void statesAreDrawn()
    {
        QFETCH(int, side);
        QFETCH(double, scale);
        for (const Health health : healths) {
            const QImage image = render(icons::state(health), {side, side}, scale);
            QVERIFY(!image.isNull());
            // A pixmap is never blown up: the icon is drawn sharp at 16 px and every scale of a screen.
            QVERIFY(image.width() >= qRound(16 * scale));
            QVERIFY2(coverage(image) > 20 && coverage(image) < 95, qPrintable(QString::number(coverage(image))));
        }
    }

    /// Colour is not alone: any two states have different outlines, also for who sees no colours.
    void statesDifferInShape_data() { sizes(); }
    void statesDifferInShape()
    {
        QFETCH(int, side);
        QFETCH(double, scale);
        for (qsizetype i = 0; i < healths.size(); ++i) {
            for (qsizetype j = 0; j < i; ++j) {
                const QImage a = render(icons::state(healths.at(i)), {side, side}, scale);
                const QImage b = render(icons::state(healths.at(j)), {side, side}, scale);
                QCOMPARE(a.size(), b.size());
                const double difference = outlineDifference(a, b);
                QVERIFY2(difference > 8, qPrintable(QStringLiteral("%1 %2: %3 %").arg(i).arg(j).arg(difference)));
            }
        }
    }

    /// In the tree both halves are drawn, and no two kinds of nodes look alike.
    void kindsAreDrawnAndDiffer_data()
    {
        QTest::addColumn<double>("scale");
        for (const double scale : {1.0, 1.25, 1.5, 2.0}) {
            QTest::addRow("%.0f %%", scale * 100) << scale;
        }
    }
    void kindsAreDrawnAndDiffer()
    {
        QFETCH(double, scale);
        QList<QImage> kinds;
        for (const icons::Node node : nodes) {
            const QImage image = render(icons::tree(node, Health::Good), icons::treeSize(), scale);
            const int half = image.width() / 2;
            QVERIFY(coverage(image.copy(0, 0, half, image.height())) > 20);
            const QImage kind = image.copy(half, 0, image.width() - half, image.height());
            QVERIFY2(coverage(kind) > 10, qPrintable(QString::number(coverage(kind))));
            for (const QImage &other : std::as_const(kinds)) {
                QVERIFY(outlineDifference(kind, other) > 8);
            }
            kinds += kind;
        }
    }

    /// Lines in grey and blue would drown in a blue selection: there they take the colour of its text, light or dark.
    void selectedKindFollowsThePalette()
    {
        const QPalette before = QGuiApplication::palette();
        for (const QColor &text : {QColor(Qt::white), QColor(Qt::black)}) {
            QPalette palette = before;
            palette.setColor(QPalette::HighlightedText, text);
            QGuiApplication::setPalette(palette);
            const QImage image =
                render(icons::tree(icons::Node::Server, Health::Good), icons::treeSize(), 2, QIcon::Selected);
            int matching = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = image.width() * 2 / 3; x < image.width(); ++x) {
                    matching += image.pixelColor(x, y) == text ? 1 : 0;
                }
            }
            QVERIFY(matching > 20);
        }
        QGuiApplication::setPalette(before);
    }

    void trayShowsTheWorstState()
    {
        const QImage good = render(icons::tray(Health::Good), {32, 32}, 1);
        const QImage error = render(icons::tray(Health::Error), {32, 32}, 1);
        QVERIFY(good != error);
        QVERIFY(coverage(render(icons::program(), {16, 16}, 1)) > 80);
        QVERIFY(coverage(render(icons::information(), {16, 16}, 1)) > 5);
    }

private:
    void sizes()
    {
        QTest::addColumn<int>("side");
        QTest::addColumn<double>("scale");
        for (const int side : {16, 24, 32}) {
            for (const double scale : {1.0, 1.25, 1.5, 2.0}) {
                QTest::addRow("%d px at %.0f %%", side, scale * 100) << side << scale;
            }
        }
    }
};

QTEST_MAIN(TestIcons)
#include "tst_icons.moc"
