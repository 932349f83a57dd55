<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>About</source>
        <translation>О программе</translation>
    </message>
    <message>
        <source>Watches buildings: polls inclinometers and accelerometers, shows, saves and serves their readings.</source>
        <translation>Наблюдает за зданиями: опрашивает инклинометры и акселерометры, показывает, сохраняет и передаёт их показания.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3. It comes without any warranty.</source>
        <translation>Свободная программа под лицензией GNU General Public License версии 3. Распространяется без каких-либо гарантий.</translation>
    </message>
    <message>
        <source>Built with Qt %1</source>
        <translation>Используется Qt %1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
</context>
<context>
    <name>PortPage</name>
    <message>
        <source>Comment</source>
        <translation>Комментарий</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <source>Polling time</source>
        <translation>Время опроса</translation>
    </message>
    <message>
        <source>how long polled without a break</source>
        <translation>время непрерывного опроса порта</translation>
    </message>
    <message>
        <source>Time since opening</source>
        <translation>Время после открытия</translation>
    </message>
    <message>
        <source>Bytes sent</source>
        <translation>Отправлено байт</translation>
    </message>
    <message>
        <source>Bytes received</source>
        <translation>Принято байт</translation>
    </message>
    <message>
        <source>Attempts to open</source>
        <translation>Попыток открытия</translation>
    </message>
    <message>
        <source>those that failed</source>
        <translation>количество неудачных попыток</translation>
    </message>
    <message>
        <source>Write errors</source>
        <translation>Ошибок записи</translation>
    </message>
    <message>
        <source>Read errors</source>
        <translation>Ошибок чтения</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>Ошибок CRC</translation>
    </message>
    <message>
        <source>Code of the last error</source>
        <translation>Код последней ошибки</translation>
    </message>
</context>
<context>
    <name>SensorPage</name>
    <message>
        <source>modulus of the maximum, its direction, degrees (RMS of the modulus | along X, along Y), packets in the sensor : read (samples) saved</source>
        <translation>модуль максимума, его направление, град. (СКО модуля | по X, по Y), пакетов в датчике : прочитано (отсчётов) сохранено</translation>
    </message>
    <message>
        <source>maximum along X %1, along Y %2 mm/s²</source>
        <translation>максимум по X %1, по Y %2 мм/с²</translation>
    </message>
    <message>
        <source>flags of the state : of the mode, as the sensor gives them; the program&apos;s own word is %1</source>
        <translation>флаги состояния : режима, как их передаёт датчик; слово состояния программы: %1</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Комментарий</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <source>Angles Mx, My, degrees (arc-seconds)</source>
        <translation>Углы Мх, Му, град. (угл. сек.)</translation>
    </message>
    <message>
        <source>Accelerations Ax, Ay, mm/s²</source>
        <translation>Ускорения Ах, Ау, мм/с²</translation>
    </message>
    <message>
        <source>Temperature T, °C</source>
        <translation>Температура Т, град.</translation>
    </message>
    <message>
        <source>Wind speed U, V, m/s</source>
        <translation>Скорость ветра U, V, м/с</translation>
    </message>
    <message>
        <source>Thermostat, % (rev/s)</source>
        <translation>Термостат, % (об./с)</translation>
    </message>
    <message>
        <source>power of the heater (frequency of the fan)</source>
        <translation>мощность нагревателя (частота вентилятора)</translation>
    </message>
    <message>
        <source>Status word</source>
        <translation>Слово состояния</translation>
    </message>
    <message>
        <source>Polling period, s</source>
        <translation>Период опроса, с</translation>
    </message>
    <message>
        <source>period | time of the exchange | age of the values</source>
        <translation>период | длительность обмена | возраст показаний</translation>
    </message>
    <message>
        <source>Read errors</source>
        <translation>Ошибок чтения</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>Ошибок CRC</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>the file gives “%1”, which cannot be used</source>
        <translation>в файле указано «%1», это значение использовать нельзя</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 мс</translation>
    </message>
    <message>
        <source>[Server]</source>
        <translation>[Сервер]</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Комментарий</translation>
    </message>
    <message>
        <source>IP port</source>
        <translation>IP порт</translation>
    </message>
    <message>
        <source>Modbus TCP</source>
        <translation>Modbus TCP</translation>
    </message>
    <message>
        <source>Modbus TCP, switched off</source>
        <translation>Modbus TCP, выключен</translation>
    </message>
    <message>
        <source>period of the visible elements</source>
        <translation>период обновления визуальных элементов программы</translation>
    </message>
    <message>
        <source>period of polling a port</source>
        <translation>период опроса COM-портов</translation>
    </message>
    <message>
        <source>time for resources at the start</source>
        <translation>время на инициализацию ресурсов программы</translation>
    </message>
    <message>
        <source>period of the records in the files</source>
        <translation>период сохранения результатов измерений в файлах</translation>
    </message>
    <message>
        <source>slice of any pause</source>
        <translation>квант времени для задержек</translation>
    </message>
    <message>
        <source>after a failed attempt to open a port</source>
        <translation>задержка после неудачной попытки открытия COM-порта</translation>
    </message>
    <message>
        <source>after closing a port, before it is opened again</source>
        <translation>задержка после закрытия COM-порта перед повторным открытием</translation>
    </message>
    <message>
        <source>time for an orderly end of the program</source>
        <translation>время на штатное освобождение ресурсов программы при закрытии</translation>
    </message>
    <message>
        <source>after another address is chosen</source>
        <translation>приостановка после изменения адреса датчика</translation>
    </message>
    <message>
        <source>after a polling cycle</source>
        <translation>приостановка после завершения цикла опроса</translation>
    </message>
    <message>
        <source>after a read error</source>
        <translation>приостановка после ошибки чтения</translation>
    </message>
    <message>
        <source>after a CRC error</source>
        <translation>приостановка после ошибки CRC</translation>
    </message>
    <message>
        <source>reading the answer to a command</source>
        <translation>таймаут чтения команды из COM-порта</translation>
    </message>
    <message>
        <source>writing a command</source>
        <translation>таймаут записи команды в COM-порт</translation>
    </message>
    <message>
        <source>reading data</source>
        <translation>таймаут чтения данных из COM-порта</translation>
    </message>
    <message>
        <source>writing data</source>
        <translation>таймаут записи данных в COM-порт</translation>
    </message>
    <message>
        <source>read errors in a row before the status word says so</source>
        <translation>ошибок чтения подряд до флага в слове состояния датчика</translation>
    </message>
    <message>
        <source>CRC errors in a row before the status word says so</source>
        <translation>ошибок CRC подряд до флага в слове состояния датчика</translation>
    </message>
    <message>
        <source>[More]</source>
        <translation>[Дополнительно]</translation>
    </message>
    <message>
        <source>Save to files</source>
        <translation>Сохранять в файле</translation>
    </message>
    <message>
        <source>Records shown</source>
        <translation>Отображать записей</translation>
    </message>
    <message>
        <source>Records cleared</source>
        <translation>Очищать записей</translation>
    </message>
    <message>
        <source>Hide to the tray at the start</source>
        <translation>Сворачивать в трей при запуске</translation>
    </message>
    <message>
        <source>Warn at the end of work</source>
        <translation>Предупреждать при завершении работы</translation>
    </message>
    <message>
        <source>Allow a second copy</source>
        <translation>Разрешать запуск копии</translation>
    </message>
    <message>
        <source>Allow adjustment</source>
        <translation>Разрешить настройку</translation>
    </message>
    <message>
        <source>Accelerometer&apos;s buffer</source>
        <translation>Буфер акселерометра</translation>
    </message>
    <message>
        <source>%1 packets</source>
        <translation>%1 пакетов</translation>
    </message>
    <message>
        <source>32 samples of both axes each</source>
        <translation>по 32 измерения по осям X и Y в пакете</translation>
    </message>
    <message>
        <source>[Port]</source>
        <translation>[Порт]</translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation>Включен</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Номер</translation>
    </message>
    <message>
        <source>%1 baud</source>
        <translation>%1 бод</translation>
    </message>
    <message>
        <source>[Sensor]</source>
        <translation>[Датчик]</translation>
    </message>
    <message>
        <source>Polling</source>
        <translation>Опрос</translation>
    </message>
    <message>
        <source>Number on the site</source>
        <translation>Порядковый номер</translation>
    </message>
    <message>
        <source>Address on the line</source>
        <translation>Адрес на линии</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Серийный номер</translation>
    </message>
    <message>
        <source>[Adjustment]</source>
        <translation>[Юстировка]</translation>
    </message>
    <message>
        <source>Offset Mx, degrees (arc-seconds)</source>
        <translation>Смещение Mx, град. (угл. сек.)</translation>
    </message>
    <message>
        <source>Offset My, degrees (arc-seconds)</source>
        <translation>Смещение My, град. (угл. сек.)</translation>
    </message>
    <message>
        <source>Offset T, °C</source>
        <translation>Смещение T, град.</translation>
    </message>
    <message>
        <source>Inversion of axis Y</source>
        <translation>Инверсия оси Y</translation>
    </message>
    <message>
        <source>Rotation of axis X, degrees</source>
        <translation>Поворот оси X, град.</translation>
    </message>
    <message>
        <source>Date of installation</source>
        <translation>Дата установки</translation>
    </message>
    <message>
        <source>Date of the last adjustment</source>
        <translation>Дата последней юстировки</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Примечание</translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>restarted</source>
        <translation>перезагрузка датчика</translation>
    </message>
    <message>
        <source>samples were lost</source>
        <translation>потеряна часть отсчётов</translation>
    </message>
    <message>
        <source>samples do not follow each other</source>
        <translation>ошибка синхронизации</translation>
    </message>
    <message>
        <source>tilt is not ready</source>
        <translation>углы не готовы</translation>
    </message>
    <message>
        <source>temperature is not ready</source>
        <translation>температура не готова</translation>
    </message>
    <message>
        <source>acceleration is not ready</source>
        <translation>ускорения не готовы</translation>
    </message>
    <message>
        <source>the thermostat has not settled</source>
        <translation>терморегулирование не завершено</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Выключен</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Открывается</translation>
    </message>
    <message>
        <source>Open, polling</source>
        <translation>Открыт, идёт опрос</translation>
    </message>
    <message>
        <source>Cannot be opened</source>
        <translation>Не открывается</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Связь потеряна</translation>
    </message>
    <message>
        <source>Service mode, polling is suspended</source>
        <translation>Сервисный режим, опрос приостановлен</translation>
    </message>
    <message>
        <source>No errors</source>
        <translation>Нет ошибок</translation>
    </message>
    <message>
        <source>The port is off</source>
        <translation>COM-порт отключен</translation>
    </message>
    <message>
        <source>Port error</source>
        <translation>Ошибка COM-порта</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Датчик не отвечает</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>Ошибки CRC при чтении из датчика</translation>
    </message>
    <message>
        <source>The transducer does not answer</source>
        <translation>Первичный преобразователь не отвечает</translation>
    </message>
    <message>
        <source>CRC errors of the transducer</source>
        <translation>Ошибки CRC первичного преобразователя</translation>
    </message>
    <message>
        <source>The transducer is out of range</source>
        <translation>Ошибка диапазона первичного преобразователя</translation>
    </message>
    <message>
        <source>The temperature sensor does not work</source>
        <translation>Не работает датчик температуры</translation>
    </message>
    <message>
        <source>The temperature sensor is out of range</source>
        <translation>Ошибка диапазона датчика температуры</translation>
    </message>
    <message>
        <source>The fan does not work</source>
        <translation>Не работает вентилятор</translation>
    </message>
    <message>
        <source>The thermostat takes too long to settle</source>
        <translation>Термостат слишком долго выходит на режим</translation>
    </message>
    <message>
        <source>Unknown error</source>
        <translation>Неизвестная ошибка</translation>
    </message>
    <message>
        <source>Unknown type of sensor, not polled</source>
        <translation>Неизвестный тип датчика, не опрашивается</translation>
    </message>
    <message>
        <source>Polling is off</source>
        <translation>Опрос отключен</translation>
    </message>
    <message>
        <source>Waiting for the first answer</source>
        <translation>Ожидание первого ответа</translation>
    </message>
    <message>
        <source>Answering</source>
        <translation>Отвечает</translation>
    </message>
    <message>
        <source>Answering: %1</source>
        <translation>Отвечает: %1</translation>
    </message>
    <message>
        <source>Everything works</source>
        <translation>Всё исправно</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Запускается</translation>
    </message>
    <message>
        <source>Service mode</source>
        <translation>Сервисный режим</translation>
    </message>
    <message>
        <source>There are warnings</source>
        <translation>Есть предупреждения</translation>
    </message>
    <message>
        <source>There are errors</source>
        <translation>Есть ошибки</translation>
    </message>
    <message>
        <source>Sensors good: %1</source>
        <translation>Датчиков исправно: %1</translation>
    </message>
    <message>
        <source>with errors: %1</source>
        <translation>с ошибками: %1</translation>
    </message>
    <message>
        <source>with warnings: %1</source>
        <translation>с предупреждениями: %1</translation>
    </message>
    <message>
        <source>starting: %1</source>
        <translation>запускается: %1</translation>
    </message>
    <message>
        <source>in service: %1</source>
        <translation>в сервисе: %1</translation>
    </message>
    <message>
        <source>off: %1</source>
        <translation>выключено: %1</translation>
    </message>
    <message>
        <source>(line %1)</source>
        <translation>(строка %1)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>да</translation>
    </message>
    <message>
        <source>no</source>
        <translation>нет</translation>
    </message>
</context>
<context>
    <name>gorizont::AttentionBanner</name>
    <message>
        <source>Show</source>
        <translation>Показать</translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s) need attention</source>
        <translation>
            <numerusform>%n датчик требует внимания</numerusform>
            <numerusform>%n датчика требуют внимания</numerusform>
            <numerusform>%n датчиков требуют внимания</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::ComplaintsDialog</name>
    <message>
        <source>Configuration file</source>
        <translation>Файл настроек</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the configuration file cannot be used as they are. The program works without them.</source>
        <translation>
            <numerusform>%n запись файла настроек нельзя использовать в том виде, как она есть. Программа работает без неё.</numerusform>
            <numerusform>%n записи файла настроек нельзя использовать в том виде, как они есть. Программа работает без них.</numerusform>
            <numerusform>%n записей файла настроек нельзя использовать в том виде, как они есть. Программа работает без них.</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Копировать</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
</context>
<context>
    <name>gorizont::FirstRunDialog</name>
    <message>
        <source>Gorizont Server: first start</source>
        <translation>Gorizont Server: первый запуск</translation>
    </message>
    <message>
        <source>There is no configuration file GorizontServer.ini yet.</source>
        <translation>Файла настроек GorizontServer.ini пока нет.</translation>
    </message>
    <message>
        <source>It was looked for here:</source>
        <translation>Его искали здесь:</translation>
    </message>
    <message>
        <source>Start the demo</source>
        <translation>Запустить демонстрацию</translation>
    </message>
    <message>
        <source>A simulated site with sensors; no equipment is needed</source>
        <translation>Имитация объекта с датчиками, оборудование не нужно</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Выбрать файл</translation>
    </message>
    <message>
        <source>Open a configuration file that already exists</source>
        <translation>Открыть уже существующий файл настроек</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Выход</translation>
    </message>
    <message>
        <source>Nothing is changed</source>
        <translation>Ничего не изменится</translation>
    </message>
    <message>
        <source>Configuration file</source>
        <translation>Файл настроек</translation>
    </message>
    <message>
        <source>Configuration files (*.ini);;All files (*)</source>
        <translation>Файлы настроек (*.ini);;Все файлы (*)</translation>
    </message>
</context>
<context>
    <name>gorizont::InfoPanel</name>
    <message>
        <source>Settings</source>
        <translation>Настройки</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Измерения</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Журнал</translation>
    </message>
</context>
<context>
    <name>gorizont::JournalPage</name>
    <message>
        <source>Errors</source>
        <translation>Ошибки</translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation>Включение</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Отключение</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Информация</translation>
    </message>
</context>
<context>
    <name>gorizont::MainWindow</name>
    <message>
        <source>End the work of the program?</source>
        <translation>Завершить работу программы?</translation>
    </message>
    <message>
        <source>Polling of the sensors, records and the data server will stop.</source>
        <translation>Опрос датчиков, запись и передача данных прекратятся.</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Да</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Нет</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>E&amp;xit</source>
        <translation>В&amp;ыход</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Вид</translation>
    </message>
    <message>
        <source>&amp;Ports</source>
        <translation>&amp;Порты</translation>
    </message>
    <message>
        <source>&amp;Sensors</source>
        <translation>&amp;Датчики</translation>
    </message>
    <message>
        <source>P&amp;ort</source>
        <translation>П&amp;орт</translation>
    </message>
    <message>
        <source>S&amp;ensor</source>
        <translation>Д&amp;атчик</translation>
    </message>
    <message>
        <source>Se&amp;ttings</source>
        <translation>&amp;Настройки</translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation>&amp;Измерения</translation>
    </message>
    <message>
        <source>&amp;Journal</source>
        <translation>&amp;Журнал</translation>
    </message>
    <message>
        <source>&amp;Find a sensor</source>
        <translation>Найти да&amp;тчик</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Справка</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>&amp;О программе</translation>
    </message>
</context>
<context>
    <name>gorizont::MeasurementModel</name>
    <message>
        <source>Time</source>
        <translation>Время</translation>
    </message>
    <message>
        <source>Ports</source>
        <translation>Порты</translation>
    </message>
    <message>
        <source>%1: X, ″</source>
        <translation>%1: X, ″</translation>
    </message>
    <message>
        <source>%1: Y, ″</source>
        <translation>%1: Y, ″</translation>
    </message>
    <message>
        <source>%1: T, °C</source>
        <translation>%1: T, °C</translation>
    </message>
    <message>
        <source>%1: P, %</source>
        <translation>%1: P, %</translation>
    </message>
    <message>
        <source>%1: status</source>
        <translation>%1: статус</translation>
    </message>
</context>
<context>
    <name>gorizont::PortModel</name>
    <message>
        <source>How long the port has been open, h:mm:ss</source>
        <translation>Время непрерывной работы порта, ч:мм:сс</translation>
    </message>
    <message>
        <source>Bytes sent</source>
        <translation>Количество отправленных байт</translation>
    </message>
    <message>
        <source>Bytes received</source>
        <translation>Количество принятых байт</translation>
    </message>
    <message>
        <source>Failed attempts to open the port</source>
        <translation>Количество неудачных попыток открытия порта</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Порт</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Время</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Отправлено</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Принято</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Попыток</translation>
    </message>
</context>
<context>
    <name>gorizont::PropertyModel</name>
    <message>
        <source>Parameter</source>
        <translation>Параметр</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Пояснение</translation>
    </message>
</context>
<context>
    <name>gorizont::SensorModel</name>
    <message>
        <source>Angle along X, degrees</source>
        <translation>Угол по X, угл. град.</translation>
    </message>
    <message>
        <source>Angle along Y, degrees</source>
        <translation>Угол по Y, угл. град.</translation>
    </message>
    <message>
        <source>Maximum acceleration, mm/s²</source>
        <translation>Максимальное ускорение, мм/с²</translation>
    </message>
    <message>
        <source>Root mean square of the acceleration, mm/s²</source>
        <translation>Среднеквадратичное ускорение, мм/с²</translation>
    </message>
    <message>
        <source>Temperature, °C</source>
        <translation>Температура, °C</translation>
    </message>
    <message>
        <source>Frequency of the thermostat&apos;s fan, revolutions per second</source>
        <translation>Частота вентилятора термостата, об./с</translation>
    </message>
    <message>
        <source>Power of the thermostat&apos;s heater, %</source>
        <translation>Мощность нагревательного элемента термостата, %</translation>
    </message>
    <message>
        <source>Status word of the sensor: the code, then bits 11…0</source>
        <translation>Слово состояния датчика: код, затем биты 11…0</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Датчик</translation>
    </message>
    <message>
        <source>Mx, °</source>
        <translation>Mx, °</translation>
    </message>
    <message>
        <source>My, °</source>
        <translation>My, °</translation>
    </message>
    <message>
        <source>Amax, mm/s²</source>
        <translation>Amax, мм/с²</translation>
    </message>
    <message>
        <source>Arms, mm/s²</source>
        <translation>Arms, мм/с²</translation>
    </message>
    <message>
        <source>T, °C</source>
        <translation>T, °C</translation>
    </message>
    <message>
        <source>Frequency, rev/s</source>
        <translation>Частота, об./с</translation>
    </message>
    <message>
        <source>P, %</source>
        <translation>P, %</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Статус</translation>
    </message>
</context>
<context>
    <name>gorizont::SiteTree</name>
    <message>
        <source>Find a sensor (Ctrl+F)</source>
        <translation>Найти датчик (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>gorizont::SiteTreeModel</name>
    <message>
        <source>Server</source>
        <translation>Сервер</translation>
    </message>
</context>
<context>
    <name>gorizont::StatePanel</name>
    <message>
        <source>Ports</source>
        <translation>Порты</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Датчики</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Порт</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Датчик</translation>
    </message>
</context>
<context>
    <name>gorizont::TableView</name>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копировать</translation>
    </message>
</context>
<context>
    <name>gorizont::TrayIcon</name>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Развернуть</translation>
    </message>
    <message>
        <source>E&amp;xit</source>
        <translation>В&amp;ыход</translation>
    </message>
</context>
</TS>
