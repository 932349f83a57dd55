#pragma once

#include "core/config/serverconfig.h"

#include <QDialog>

namespace gorizont {

/// What is wrong in the ini and what was done about it. Nobody has to answer it: work goes on behind it. GUI thread.
class ComplaintsDialog : public QDialog
{
    Q_OBJECT

public:
    explicit ComplaintsDialog(const QList<Complaint> &complaints, QWidget *parent = nullptr);
};

} // namespace gorizont
