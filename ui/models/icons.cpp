#include "ui/models/icons.h"

#include <QGuiApplication>
#include <QHash>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

#include <array>

namespace gorizont::icons {

namespace {

constexpr int side = 16; ///< of one symbol, device-independent pixels
constexpr int gap = 5; ///< between the two symbols of a tree icon
constexpr int treeHeight = 20; ///< of a tree icon, which leaves room between rows
constexpr std::array<double, 5> scales{1, 1.25, 1.5, 2, 3};

QString stateFile(Health health)
{
    switch (health) {
    case Health::Off: return QStringLiteral(":/icons/state-off.svg");
    case Health::Good: return QStringLiteral(":/icons/state-good.svg");
    case Health::Unknown: return QStringLiteral(":/icons/state-unknown.svg");
    case Health::Service: return QStringLiteral(":/icons/state-service.svg");
    case Health::Warning: return QStringLiteral(":/icons/state-warning.svg");
    case Health::Error: return QStringLiteral(":/icons/state-error.svg");
    }
    return {};
}

QString nodeFile(Node node)
{
    switch (node) {
    case Node::Server: return QStringLiteral(":/icons/node-server.svg");
    case Node::Port: return QStringLiteral(":/icons/node-port.svg");
    case Node::Tilt: return QStringLiteral(":/icons/sensor-tilt.svg");
    case Node::Acceleration: return QStringLiteral(":/icons/sensor-acceleration.svg");
    case Node::Usm: return QStringLiteral(":/icons/sensor-usm.svg");
    case Node::Vibration: return QStringLiteral(":/icons/sensor-vibration.svg");
    case Node::Weather: return QStringLiteral(":/icons/sensor-weather.svg");
    case Node::None: return QStringLiteral(":/icons/sensor-none.svg");
    }
    return {};
}

struct Part
{
    QString file;
    QRectF place; ///< within the icon, device-independent pixels
    bool isTextWhenSelected = false; ///< a symbol in the colours of lines would drown in the colour of the selection
};

QColor selectedText()
{
    return QGuiApplication::palette().color(QPalette::HighlightedText);
}

QPixmap drawPixmap(const QSize &size, double scale, const QList<Part> &parts, QIcon::Mode mode)
{
    QPixmap pixmap(size * scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Part &part : parts) {
        const QRectF place(part.place.topLeft() * scale, part.place.size() * scale);
        QSvgRenderer(part.file).render(&painter, place);
        if (mode == QIcon::Selected && part.isTextWhenSelected) {
            painter.setCompositionMode(QPainter::CompositionMode_SourceAtop);
            painter.fillRect(place, selectedText());
            painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
        }
    }
    return pixmap;
}

/// Draws the parts at every scale that screens have, so that no icon is ever a blown-up small one.
QIcon draw(const QSize &size, const QList<Part> &parts)
{
    QIcon icon;
    for (const double scale : scales) {
        icon.addPixmap(drawPixmap(size, scale, parts, QIcon::Normal), QIcon::Normal);
        icon.addPixmap(drawPixmap(size, scale, parts, QIcon::Selected), QIcon::Selected);
    }
    return icon;
}

/// Kept until the palette changes: the desktop may go from light to dark at any time.
template <typename Draw> QIcon cached(int key, Draw make)
{
    static QHash<int, QIcon> drawn;
    static QColor colour;
    if (colour != selectedText()) {
        colour = selectedText();
        drawn.clear();
    }
    const auto found = drawn.constFind(key);
    return found != drawn.cend() ? *found : *drawn.insert(key, make());
}

int keyOf(int group, Health health)
{
    return group * static_cast<int>(healthKinds) + static_cast<int>(health);
}

} // namespace

Node nodeOf(SensorType type)
{
    switch (type) {
    case SensorType::None: return Node::None;
    case SensorType::InD: return Node::Tilt;
    case SensorType::AnD3: return Node::Acceleration;
    case SensorType::UsmIsn: return Node::Usm;
    case SensorType::LVims: return Node::Vibration;
    case SensorType::Mk14: return Node::Weather;
    }
    return Node::None;
}

QSize treeSize()
{
    return {2 * side + gap, treeHeight};
}

QIcon state(Health health)
{
    return cached(keyOf(100, health), [health] {
        return draw({side, side}, {{stateFile(health), QRectF(0, 0, side, side)}});
    });
}

QIcon information()
{
    return cached(-2, [] {
        return draw({side, side}, {{QStringLiteral(":/icons/information.svg"), QRectF(0, 0, side, side)}});
    });
}

QIcon tree(Node node, Health health)
{
    constexpr int top = (treeHeight - side) / 2;
    return cached(keyOf(static_cast<int>(node), health), [node, health] {
        return draw(
            treeSize(),
            {{stateFile(health), QRectF(0.5, top + 0.5, side - 1, side - 1), health == Health::Off},
             {nodeFile(node), QRectF(side + gap, top, side, side), true}});
    });
}

QIcon program()
{
    return cached(-1, [] {
        QIcon icon;
        for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
            icon.addPixmap(draw({size, size}, {{QStringLiteral(":/icons/gorizont.svg"), QRectF(0, 0, size, size)}})
                               .pixmap(size, size));
        }
        return icon;
    });
}

QIcon tray(Health worst)
{
    constexpr int size = 32;
    constexpr int badge = 18;
    return cached(keyOf(200, worst), [worst] {
        return draw(
            {size, size},
            {{QStringLiteral(":/icons/gorizont.svg"), QRectF(0, 0, size - 4, size - 4)},
             {stateFile(worst), QRectF(size - badge, size - badge, badge, badge)}});
    });
}

} // namespace gorizont::icons
