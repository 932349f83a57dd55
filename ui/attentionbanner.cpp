#include "ui/attentionbanner.h"

#include "ui/models/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace gorizont {

AttentionBanner::AttentionBanner(QWidget *parent)
    : QFrame(parent)
    , m_text(new QLabel(this))
{
    setObjectName(QStringLiteral("attentionBanner"));
    // Dark red with white text reads the same on light and on dark palettes.
    setStyleSheet(QStringLiteral("#attentionBanner { background: #a4262c; } #attentionText { color: white; }"));
    m_text->setObjectName(QStringLiteral("attentionText"));
    auto *icon = new QLabel(this);
    icon->setPixmap(icons::state(Health::Error).pixmap(QSize(16, 16), devicePixelRatioF()));
    auto *button = new QPushButton(tr("Show"), this);
    button->setObjectName(QStringLiteral("attentionButton"));
    connect(button, &QPushButton::clicked, this, &AttentionBanner::listWanted);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 6, 4);
    layout->setSpacing(8);
    layout->addWidget(icon);
    layout->addWidget(m_text, 1);
    layout->addWidget(button);
    hide();
}

void AttentionBanner::setCount(int sensors)
{
    if (sensors == m_count) {
        return;
    }
    m_count = sensors;
    m_text->setText(tr("%n sensor(s) need attention", nullptr, sensors));
    setVisible(sensors > 0);
}

} // namespace gorizont
