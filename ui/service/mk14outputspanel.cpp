#include "ui/service/mk14outputspanel.h"

#include "ui/models/valuetext.h"
#include "ui/models/weathertext.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>

namespace gorizont {

namespace {

constexpr int boxesInRow = 8;

QString hexadecimal(quint32 word)
{
    return QStringLiteral("0x") + QStringLiteral("%1").arg(word, 8, 16, QLatin1Char('0')).toUpper();
}

} // namespace

Mk14OutputsPanel::Mk14OutputsPanel(QWidget *parent)
    : QWidget(parent)
    , m_number(new QLineEdit(this))
    , m_inForce(new QLabel(this))
    , m_set(new QPushButton(tr("Set the &outputs…"), this))
{
    m_number->setObjectName(QStringLiteral("outputWord"));
    m_number->setToolTip(tr("The same as a number: decimal, or hexadecimal with 0x in front"));
    m_inForce->setObjectName(QStringLiteral("outputsInForce"));
    m_inForce->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_set->setObjectName(QStringLiteral("setOutputs"));
    m_set->setAutoDefault(false);
    auto *hint = new QLabel(
        tr("Every poll repeats the control word that was set last, so that polling switches nothing. What is set here "
           "holds until the program ends; after its next start Outputs{i} of the configuration file holds."),
        this);
    hint->setWordWrap(true);
    auto *word = new QLabel(tr("Control &word:"), this);
    word->setBuddy(m_number);
    auto *grid = new QGridLayout;
    grid->addWidget(new QLabel(tr("In force:"), this), 0, 0);
    grid->addWidget(m_inForce, 0, 1, 1, 2);
    grid->addWidget(word, 1, 0);
    grid->addWidget(m_number, 1, 1);
    grid->addWidget(m_set, 1, 2);
    grid->setColumnStretch(1, 1);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(hint);
    layout->addWidget(makeBoxes());
    layout->addLayout(grid);
    layout->addStretch(1);
    connect(m_number, &QLineEdit::textEdited, this, &Mk14OutputsPanel::takeNumber);
    connect(m_set, &QPushButton::clicked, this, &Mk14OutputsPanel::setWanted);
    showWord({});
}

QWidget *Mk14OutputsPanel::makeBoxes()
{
    auto *boxes = new QWidget(this);
    auto *grid = new QGridLayout(boxes);
    grid->setContentsMargins(0, 0, 0, 0);
    for (int output = 0; output < count; ++output) {
        auto *box = new QCheckBox(QString::number(output), boxes);
        box->setObjectName(QStringLiteral("output%1").arg(output));
        box->setAccessibleName(tr("Output %1").arg(output));
        connect(box, &QCheckBox::toggled, this, [this] {
            if (!m_isFilling) {
                m_problem = false;
                writeNumber();
                Q_EMIT edited();
            }
        });
        grid->addWidget(box, output / boxesInRow, output % boxesInRow);
        m_boxes[static_cast<std::size_t>(output)] = box;
    }
    return boxes;
}

QWidgetList Mk14OutputsPanel::tabOrder() const
{
    return QWidgetList(m_boxes.begin(), m_boxes.end()) + QWidgetList{m_number, m_set};
}

std::optional<quint32> Mk14OutputsPanel::typedWord(const QString &text)
{
    const QString trimmed = text.trimmed();
    const bool isHexadecimal = trimmed.startsWith(QStringLiteral("0x"), Qt::CaseInsensitive);
    bool isWord = false;
    const quint32 word = isHexadecimal ? trimmed.mid(2).toUInt(&isWord, 16) : trimmed.toUInt(&isWord, 10);
    return isWord ? std::optional(word) : std::nullopt;
}

quint32 Mk14OutputsPanel::word() const
{
    quint32 word = 0;
    for (std::size_t output = 0; output < m_boxes.size(); ++output) {
        word |= m_boxes[output]->isChecked() ? 1U << output : 0U;
    }
    return word;
}

void Mk14OutputsPanel::setBoxes(quint32 word)
{
    const QScopedValueRollback filling(m_isFilling, true);
    for (std::size_t output = 0; output < m_boxes.size(); ++output) {
        m_boxes[output]->setChecked(word >> output & 1U);
    }
}

void Mk14OutputsPanel::writeNumber()
{
    m_number->setText(hexadecimal(word()));
}

void Mk14OutputsPanel::takeNumber(const QString &text)
{
    const auto typed = typedWord(text);
    m_problem = !typed;
    if (typed) {
        setBoxes(*typed);
    }
    Q_EMIT edited();
}

void Mk14OutputsPanel::showWord(std::optional<quint32> word)
{
    m_shown = word;
    m_problem = false;
    setBoxes(word.value_or(0));
    m_inForce->setText(word ? weathertext::digital(*word) : valuetext::absent());
    if (word) {
        writeNumber();
    } else {
        m_number->clear();
    }
}

/// The word in force may be sent again: a station that restarted has forgotten it.
void Mk14OutputsPanel::setControls(bool isShown)
{
    const bool mayEdit = isShown && m_shown;
    for (QCheckBox *box : m_boxes) {
        box->setEnabled(mayEdit);
    }
    m_number->setEnabled(mayEdit);
    m_set->setEnabled(mayEdit && !m_problem);
}

} // namespace gorizont
