#include "ui/service/usmrecordspanel.h"

#include "ui/models/valuetext.h"
#include "ui/service/usmtext.h"
#include "ui/service/valuelabel.h"

#include <QGridLayout>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace gorizont {

namespace {

QPushButton *makeButton(const QString &text, const QString &objectName, QWidget *parent)
{
    auto *button = new QPushButton(text, parent);
    button->setObjectName(objectName);
    button->setAutoDefault(false);
    return button;
}

QString spanOf(const QList<usmisn::Value> &records)
{
    if (records.isEmpty()) {
        return valuetext::absent();
    }
    const auto [first, last] = std::minmax_element(records.begin(), records.end(), [](const auto &a, const auto &b) {
        return a.timestamp < b.timestamp;
    });
    return usmtext::time(first->timestamp) + QStringLiteral(" – ") + usmtext::time(last->timestamp);
}

} // namespace

UsmRecordsPanel::UsmRecordsPanel(QWidget *parent)
    : QWidget(parent)
    , m_progress(new QProgressBar(this))
    , m_new(makeButton(tr("Download the &new ones"), QStringLiteral("downloadNew"), this))
    , m_all(makeButton(tr("Download &all"), QStringLiteral("downloadAll"), this))
    , m_stop(makeButton(tr("Sto&p"), QStringLiteral("stopDownload"), this))
    , m_save(makeButton(tr("Save as &CSV…"), QStringLiteral("saveRecords"), this))
{
    m_progress->setObjectName(QStringLiteral("recordsProgress"));
    m_progress->setTextVisible(false);
    m_new->setToolTip(tr("Those that were not read before. The device counts as read what it has sent."));
    m_all->setToolTip(
        tr("Up to %1 records; some minutes at 9600, in which the other sensors of the port are not asked.")
            .arg(usmisn::memorySize));
    auto *layout = new QGridLayout(this);
    layout->addWidget(makeCounts(), 0, 0, 1, 3);
    layout->addWidget(m_progress, 1, 0, 1, 2);
    layout->addWidget(m_stop, 1, 2);
    layout->addWidget(m_new, 2, 0);
    layout->addWidget(m_all, 2, 1);
    layout->addWidget(m_save, 2, 2);
    layout->setRowStretch(3, 1);
    connect(m_new, &QPushButton::clicked, this, [this] { Q_EMIT downloadWanted(usmisn::RecordMask::New); });
    connect(m_all, &QPushButton::clicked, this, [this] { Q_EMIT downloadWanted(usmisn::RecordMask::All); });
    connect(m_stop, &QPushButton::clicked, this, &UsmRecordsPanel::stopWanted);
    connect(m_save, &QPushButton::clicked, this, &UsmRecordsPanel::saveWanted);
    showBook({});
    setControls(false, false, false);
}

QWidgetList UsmRecordsPanel::tabOrder() const
{
    return {m_stop, m_new, m_all, m_save};
}

QWidget *UsmRecordsPanel::makeCounts()
{
    auto *counts = new QWidget(this);
    m_count = valueLabel(QStringLiteral("recordCount"), QStringLiteral("1720"), counts);
    m_span = valueLabel(QStringLiteral("recordSpan"), QStringLiteral("00:00:00 00.00.00 – 00:00:00 00.00.00"), counts);
    m_missing = valueLabel(QStringLiteral("recordsMissing"), QStringLiteral("1720"), counts);
    m_missing->setToolTip(
        tr("How many numbers of measurements (MeasID) are missing between the first and the last one"));
    m_archive = valueLabel(QStringLiteral("recordsArchive"), {}, counts);
    m_archive->setWordWrap(true);
    m_archive->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_archive->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    auto *grid = new QGridLayout(counts);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(new QLabel(tr("Records here:"), counts), 0, 0);
    grid->addWidget(m_count, 0, 1);
    grid->addWidget(new QLabel(tr("Measured:"), counts), 1, 0);
    grid->addWidget(m_span, 1, 1);
    grid->addWidget(new QLabel(tr("Measurements missing:"), counts), 2, 0);
    grid->addWidget(m_missing, 2, 1);
    grid->addWidget(new QLabel(tr("Archive:"), counts), 3, 0, Qt::AlignTop);
    grid->addWidget(m_archive, 3, 1);
    grid->setColumnStretch(1, 1);
    return counts;
}

void UsmRecordsPanel::showBook(const usmisn::RecordBook &book)
{
    m_count->setText(QString::number(book.size()));
    m_span->setText(spanOf(book.records()));
    m_missing->setText(QString::number(book.missing()));
}

void UsmRecordsPanel::showArchive(const QString &text)
{
    m_archive->setText(text);
}

void UsmRecordsPanel::setControls(bool mayDownload, bool isRunning, bool hasRecords)
{
    m_new->setEnabled(mayDownload);
    m_all->setEnabled(mayDownload);
    m_stop->setEnabled(isRunning);
    m_save->setEnabled(hasRecords);
    m_progress->setRange(0, isRunning ? 0 : 1); // nobody knows how many will come
}

} // namespace gorizont
