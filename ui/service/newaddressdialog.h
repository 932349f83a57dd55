#pragma once

#include "core/values/lineconfig.h"

#include <QDialog>

class QComboBox;

namespace gorizont {

/// The window behind <Изменить> of an ИН-Д3 (manual 000, section 8.13): a list of free addresses. GUI thread.
class NewAddressDialog : public QDialog
{
    Q_OBJECT

public:
    NewAddressDialog(const LineConfig &line, int address, const QList<int> &free, QWidget *parent = nullptr);

    int address() const; ///< the one that is chosen

private:
    QComboBox *m_addresses;
};

} // namespace gorizont
