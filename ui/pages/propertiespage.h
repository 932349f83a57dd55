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
    void onNamesChanged();
    void mergeHeadings();
    void fitNames();

    PropertyModel *m_model;
    TableView *m_view;
    QString m_widestName; ///< so far: the column does not jump from one thing to the next
};

} // namespace gorizont
