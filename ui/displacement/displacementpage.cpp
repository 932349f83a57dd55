#include "ui/displacement/displacementpage.h"

#include "ui/displacement/profilemodel.h"
#include "ui/displacement/profileplot.h"
#include "ui/models/valuetext.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>

#include <algorithm>

namespace gorizont {

namespace {

QString titleOf(const ChainConfig &chain)
{
    return chain.name.isEmpty() ? DisplacementPage::tr("Chain %1").arg(chain.index)
                                : DisplacementPage::tr("Chain %1: %2").arg(chain.index).arg(chain.name);
}

void setColumns(TableColumns &columns)
{
    columns.setSample(ProfileModel::Number, QStringLiteral("1000"));
    columns.setElastic(ProfileModel::Place, QStringLiteral("Фундамент, ось 1/А"));
    for (int column = ProfileModel::Height; column < ProfileModel::ColumnCount; ++column) {
        columns.setSample(column, QStringLiteral("-1000.00"));
    }
}

} // namespace

DisplacementPage::DisplacementPage(const SensorRegistry &registry, const QString &zeroFolder, QWidget *parent)
    : QWidget(parent)
    , m_registry(registry)
    , m_files(zeroFolder)
    , m_chain(new QComboBox(this))
    , m_store(new QPushButton(tr("&Store as zero"), this))
    , m_remove(new QPushButton(tr("&Forget the zero…"), this))
    , m_zeroText(new QLabel(this))
    , m_x(new ProfilePlot(ProfilePlot::Plane::X, this))
    , m_y(new ProfilePlot(ProfilePlot::Plane::Y, this))
    , m_model(new ProfileModel(registry, this))
    , m_table(new TableView(QStringLiteral("profileTable"), this))
    , m_tick(new QTimer(this))
{
    setObjectName(QStringLiteral("displacementPage"));
    build();
    m_tick->setInterval(std::chrono::milliseconds(500));
    connect(m_tick, &QTimer::timeout, this, &DisplacementPage::refresh);
    for (const ChainConfig &chain : registry.chains()) {
        m_chain->addItem(titleOf(chain));
    }
    connect(m_chain, &QComboBox::currentIndexChanged, this, &DisplacementPage::choose);
    connect(m_store, &QPushButton::clicked, this, &DisplacementPage::storeZero);
    connect(m_remove, &QPushButton::clicked, this, &DisplacementPage::removeZero);
    choose(m_chain->currentIndex());
}

QWidget *DisplacementPage::makeBar()
{
    auto *bar = new QWidget(this);
    auto *layout = new QHBoxLayout(bar);
    const int margin = TableColumns::sideMargin;
    layout->setContentsMargins(margin, margin, margin, margin);
    m_chain->setObjectName(QStringLiteral("chainBox"));
    m_chain->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_chain->setAccessibleName(tr("Chain of sensors"));
    m_store->setObjectName(QStringLiteral("storeZero"));
    m_store->setToolTip(tr("Keeps the present shape, to see what changes from now on"));
    m_remove->setObjectName(QStringLiteral("removeZero"));
    m_zeroText->setObjectName(QStringLiteral("zeroText"));
    m_zeroText->setWordWrap(true); // a sentence must not widen the window
    layout->addWidget(m_chain);
    layout->addWidget(m_zeroText, 1);
    layout->addWidget(m_store);
    layout->addWidget(m_remove);
    return bar;
}

void DisplacementPage::build()
{
    setFocusProxy(m_table);
    m_table->setModel(m_model);
    m_table->setEmptyText(tr("The configuration names no chain of sensors ([Chain1])."));
    setColumns(m_table->columns());
    auto *planes = new QWidget(this);
    auto *sideBySide = new QHBoxLayout(planes);
    sideBySide->setContentsMargins(0, 0, 0, 0);
    sideBySide->addWidget(m_x);
    sideBySide->addWidget(m_y);
    auto *splitter = new QSplitter(Qt::Vertical, this);
    splitter->setObjectName(QStringLiteral("profileRows"));
    splitter->addWidget(planes);
    splitter->addWidget(m_table);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    splitter->setChildrenCollapsible(false);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeBar());
    layout->addWidget(splitter, 1);
}

void DisplacementPage::choose(int row)
{
    m_zero = row >= 0 ? m_files.load(m_registry.chains().at(row).index) : std::nullopt;
    refresh();
}

void DisplacementPage::refresh()
{
    const int row = m_chain->currentIndex();
    m_nodes = row >= 0 ? m_registry.nodesOf(m_registry.chains().at(row)) : std::vector<ChainNode>();
    m_x->show(m_nodes, m_zero ? &*m_zero : nullptr);
    m_y->show(m_nodes, m_zero ? &*m_zero : nullptr);
    m_model->setNodes(m_nodes, m_zero);
    tellZero();
}

void DisplacementPage::tellZero()
{
    const bool isWhole = !m_nodes.empty() && m_nodes.back().sum.has_value();
    m_store->setEnabled(isWhole);
    m_remove->setEnabled(m_zero.has_value());
    QString text = m_zero ? tr("Zero of %1").arg(valuetext::clock(m_zero->time)) : tr("No zero is stored.");
    const auto isOther = [this](const ChainNode &node) { return !m_zero->at(node); };
    if (m_zero && std::ranges::any_of(m_nodes, isOther)) {
        text += QStringLiteral(". ") + tr("Sensors that are new or stand at another height are not compared.");
    }
    if (!isWhole && !m_nodes.empty()) {
        text += u' ' + tr("The shape ends below the first sensor without a valid tilt.");
    }
    m_zeroText->setText(text);
}

/// What was stored before cannot be measured again: it is replaced only by whoever says so.
void DisplacementPage::storeZero()
{
    const auto zero = ProfileZero::of(m_nodes, utcNow());
    if (!zero) {
        return;
    }
    if (!m_zero) {
        keep(*zero);
        return;
    }
    ask("replaceZero", tr("Replace the zero of %1 by the present shape?").arg(valuetext::clock(m_zero->time)),
        tr("&Replace"), [this, zero] { keep(*zero); });
}

void DisplacementPage::keep(const ProfileZero &zero)
{
    if (m_files.save(m_registry.chains().at(m_chain->currentIndex()).index, zero)) {
        m_zero = zero;
        refresh();
        return;
    }
    warn(tr("The zero was not stored: %1. Check the disk and the rights, then try again.").arg(m_files.error()));
}

void DisplacementPage::removeZero()
{
    ask("removeZero", tr("Forget the zero of %1?").arg(valuetext::clock(m_zero->time)), tr("&Forget"),
        [this] { forgetZero(); });
}

/// Returns at once: readings go on while the question is open.
void DisplacementPage::ask(const char *name, const QString &text, const QString &yes, const std::function<void()> &go)
{
    auto *question = new QMessageBox(QMessageBox::Question, window()->windowTitle(), text, {}, this);
    question->setObjectName(QLatin1String(name) + QStringLiteral("Question"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton *agree = question->addButton(yes, QMessageBox::YesRole);
    agree->setObjectName(QLatin1String(name) + QStringLiteral("Yes"));
    QPushButton *no = question->addButton(tr("&Cancel"), QMessageBox::NoRole);
    no->setObjectName(QLatin1String(name) + QStringLiteral("No"));
    question->setDefaultButton(no);
    question->setEscapeButton(no);
    connect(agree, &QPushButton::clicked, this, go);
    question->open();
}

void DisplacementPage::forgetZero()
{
    if (m_files.remove(m_registry.chains().at(m_chain->currentIndex()).index)) {
        m_zero.reset();
        refresh();
        return;
    }
    warn(tr("The zero was not removed: %1. Check the rights, then try again.").arg(m_files.error()));
}

void DisplacementPage::warn(const QString &text)
{
    auto *warning = new QMessageBox(QMessageBox::Warning, window()->windowTitle(), text, QMessageBox::Ok, this);
    warning->setObjectName(QStringLiteral("zeroWarning"));
    warning->setAttribute(Qt::WA_DeleteOnClose);
    warning->open();
}

void DisplacementPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
    m_tick->start();
}

void DisplacementPage::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_tick->stop();
}

} // namespace gorizont
