#include "ui/attentionbanner.h"

#include "core/alarms/alarmtext.h"
#include "core/alarms/alarmwatch.h"
#include "ui/models/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace gorizont {

AttentionBanner::AttentionBanner(AlarmWatch &alarms, QWidget *parent)
    : QFrame(parent)
    , m_alarms(alarms)
    , m_text(new QLabel(this))
{
    setObjectName(QStringLiteral("attentionBanner"));
    // Dark red with white reads the same on light and on dark palettes.
    setStyleSheet(QStringLiteral("#attentionBanner { background: #a4262c; } #attentionText { color: white; } "
                                 "#attentionIcon { background: white; border-radius: 9px; padding: 1px; }"));
    m_text->setObjectName(QStringLiteral("attentionText"));
    m_text->setTextFormat(Qt::PlainText); // names of sensors are what the ini says
    m_text->setWordWrap(true);
    auto *icon = new QLabel(this);
    icon->setObjectName(QStringLiteral("attentionIcon"));
    icon->setFixedSize(18, 18);
    icon->setPixmap(icons::state(Health::Error).pixmap(QSize(16, 16), devicePixelRatioF()));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 6, 4);
    layout->setSpacing(8);
    layout->addWidget(icon);
    layout->addWidget(m_text, 1);
    const QPushButton *list = addButton(tr("Show"), QStringLiteral("attentionShow"));
    QPushButton *accept = addButton(tr("Accept"), QStringLiteral("attentionAccept"));
    accept->setToolTip(
        tr("The messages are known: they leave the list, the sensors stay marked until they work again"));
    connect(list, &QPushButton::clicked, this, &AttentionBanner::listWanted);
    connect(accept, &QPushButton::clicked, this, [this] { m_alarms.acknowledge(m_shown); });
    connect(&alarms, &AlarmWatch::changed, this, &AttentionBanner::refresh);
    refresh();
}

QPushButton *AttentionBanner::addButton(const QString &title, const QString &objectName)
{
    auto *button = new QPushButton(title, this);
    button->setObjectName(objectName);
    layout()->addWidget(button);
    return button;
}

void AttentionBanner::refresh()
{
    const Alarms alarms = m_alarms.unacknowledged();
    m_shown.clear();
    for (const Alarm &alarm : alarms) {
        m_shown.append(alarm.id);
    }
    setVisible(!alarms.isEmpty());
    if (alarms.isEmpty()) {
        return;
    }
    const Alarm &newest = alarms.last();
    const QString sentence = alarmtext::sentence(newest);
    m_text->setText(
        alarms.size() == 1 ? QStringLiteral("%1. %2").arg(sentence, alarmtext::advice(newest))
                           : tr("%1. The newest message: %2").arg(alarmtext::sensorsNeedAttention(alarms), sentence));
}

} // namespace gorizont
