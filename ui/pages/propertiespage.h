#pragma once

#include "ui/models/property.h"

#include <QWidget>

namespace gorizont {

class PropertyModel;
class TableView;

/// A page that describes one thing: <Порт>, <Датчик>, <Настройки>. GUI thread.
class PropertiesPage : public QWidget
{
    Q_OBJECT

public:
    enum class Notes : quint8 { InToolTips, InColumn };

    PropertiesPage(const QString &tableName, Notes notes, QWidget *parent = nullptr);

    void setProperties(const Properties &properties);

private:
    void mergeHeadings();

    PropertyModel *m_model;
    TableView *m_view;
};

} // namespace gorizont
