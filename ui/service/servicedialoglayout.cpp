// What the service windows are made of; how they behave stands in servicedialog.cpp.

#include "ui/service/portgroup.h"
#include "ui/service/servicedialog.h"
#include "ui/service/servicetext.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QTimer>

namespace gorizont {

namespace {

constexpr std::chrono::seconds livePeriod(1);
constexpr int messageLines = 3;

/// As large as it wants to be without its scroll area, if the screen has the room.
void resizeToContent(QDialog &dialog, const QScrollArea &area)
{
    QSize wanted = dialog.layout()->sizeHint() - area.sizeHint() + area.widget()->sizeHint();
    const QSize available = dialog.screen()->availableSize() * 9 / 10; // the frame of the window needs some
    if (wanted.height() > available.height()) {
        wanted.rwidth() += dialog.style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    }
    dialog.resize(wanted.boundedTo(available).expandedTo(dialog.minimumSizeHint()));
}

} // namespace

ServiceDialog::ServiceDialog(SensorType type, const ServicePort &port, QWidget *parent)
    : QDialog(parent)
    , m_type(type)
    , m_port(port)
    , m_portGroup(new PortGroup(port.line, this))
    , m_addresses(new QComboBox(this))
    , m_scan(new ScanPanel(this))
    , m_message(new QLabel(this))
    , m_exit(new QPushButton(tr("Ex&it"), this))
    , m_liveTimer(new QTimer(this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(servicetext::menuTitle(type, port.line.title()));
    m_addresses->setObjectName(QStringLiteral("addressCombo"));
    m_message->setObjectName(QStringLiteral("serviceMessage"));
    m_message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_message->setWordWrap(true);
    m_message->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    m_message->setMinimumHeight(messageLines * fontMetrics().lineSpacing());
    m_exit->setObjectName(QStringLiteral("serviceExit"));
    m_liveTimer->setObjectName(QStringLiteral("liveTimer"));
    m_liveTimer->setInterval(livePeriod);
    connect(m_portGroup, &PortGroup::toggleWanted, this, &ServiceDialog::togglePort);
    connect(m_addresses, &QComboBox::activated, this, &ServiceDialog::choose);
    connect(m_scan, &ScanPanel::scanWanted, this, [this] {
        confirm(unfinished(false), tr("&Discard"), [this] { startScan(m_address); });
    });
    connect(m_scan, &ScanPanel::sensorFound, this, [this](int address) {
        m_addresses->addItem(QString::number(address), address);
    });
    connect(m_scan, &ScanPanel::finished, this, &ServiceDialog::showFound);
    connect(m_exit, &QPushButton::clicked, this, &ServiceDialog::reject);
    connect(m_liveTimer, &QTimer::timeout, this, [this] {
        if (isReady() && m_address != 0 && m_session->isIdle()) {
            readLive();
        }
    });
}

void ServiceDialog::setUp(QWidget *groups, const QWidgetList &tabOrder, QPushButton *besideExit)
{
    auto *content = new QWidget(this);
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->addWidget(m_portGroup);
    contentLayout->addWidget(groups);
    contentLayout->addStretch(1);
    auto *area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(content);
    auto *bottom = new QHBoxLayout;
    if (besideExit) {
        bottom->addWidget(besideExit);
    }
    bottom->addStretch(1);
    bottom->addWidget(m_exit);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(area, 1);
    layout->addWidget(m_scan);
    layout->addWidget(m_message);
    layout->addLayout(bottom);

    QWidgetList order{m_portGroup};
    order << tabOrder << m_scan;
    if (besideExit) {
        order << besideExit;
    }
    order << m_exit;
    for (qsizetype i = 1; i < order.size(); ++i) {
        setTabOrder(order.at(i - 1), order.at(i));
    }
    m_scan->setFocus();
    resizeToContent(*this, *area);
    refresh();
}

void ServiceDialog::confirm(const QString &question, const QString &yes, const Action &go, const Action &stay)
{
    if (question.isEmpty()) {
        go();
        return;
    }
    if (m_question) {
        m_question->raise();
        return;
    }
    m_question = new QMessageBox(QMessageBox::Question, windowTitle(), question, QMessageBox::NoButton, this);
    m_question->setObjectName(QStringLiteral("serviceQuestion"));
    m_question->setTextFormat(Qt::PlainText); // names of devices stand in it
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton *goButton = m_question->addButton(yes, QMessageBox::DestructiveRole);
    goButton->setObjectName(QStringLiteral("questionGo"));
    QPushButton *stayButton = m_question->addButton(tr("&Back"), QMessageBox::RejectRole);
    stayButton->setObjectName(QStringLiteral("questionStay"));
    m_question->setDefaultButton(stayButton);
    m_question->setEscapeButton(stayButton);
    connect(m_question, &QDialog::finished, this, [this, goButton, go, stay] {
        const bool goes = m_question && m_question->clickedButton() == goButton;
        m_question.clear();
        if (goes) {
            go();
        } else if (stay) {
            stay();
        }
    });
    m_question->open();
}

} // namespace gorizont
