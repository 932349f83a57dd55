#include "ui/service/newaddressdialog.h"

#include "ui/service/servicetext.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace gorizont {

NewAddressDialog::NewAddressDialog(const LineConfig &line, int address, const QList<int> &free, QWidget *parent)
    : QDialog(parent)
    , m_addresses(new QComboBox(this))
{
    setObjectName(QStringLiteral("newAddressDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("New address"));
    m_addresses->setObjectName(QStringLiteral("newAddressCombo"));
    for (const int one : free) {
        m_addresses->addItem(servicetext::addressTitle(line, one), one);
    }
    m_addresses->setCurrentIndex(-1);
    auto *hint = new QLabel(tr("Addresses where a sensor was found are not offered."), this);
    hint->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(this);
    QPushButton *apply = buttons->addButton(tr("&Apply"), QDialogButtonBox::AcceptRole);
    apply->setObjectName(QStringLiteral("newAddressApply"));
    apply->setDefault(true);
    apply->setEnabled(false);
    connect(m_addresses, &QComboBox::currentIndexChanged, apply, [apply](int index) { apply->setEnabled(index >= 0); });
    buttons->addButton(tr("&Cancel"), QDialogButtonBox::RejectRole)->setObjectName(QStringLiteral("newAddressCancel"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *layout = new QFormLayout(this);
    layout->addRow(tr("Address on the line:"), new QLabel(QString::number(address), this));
    layout->addRow(tr("&New address:"), m_addresses);
    layout->addRow(hint);
    layout->addRow(buttons);
}

int NewAddressDialog::address() const
{
    return m_addresses->currentData().toInt();
}

} // namespace gorizont
