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
    <name>And3Driver</name>
    <message>
        <source>The sensor has restarted.</source>
        <translation>Датчик перезагрузился.</translation>
    </message>
    <message>
        <source>The sensor counts its measurements anew.</source>
        <translation>Датчик начал отсчёт измерений заново.</translation>
    </message>
    <message>
        <source>The buffer of accelerations overran, packets lost: %1.</source>
        <translation>Переполнен буфер ускорений, потеряно пакетов: %1.</translation>
    </message>
    <message>
        <source>The recording of accelerations was stopped; it is started again.</source>
        <translation>Запись ускорений была остановлена; она запущена снова.</translation>
    </message>
    <message>
        <source>Firmware %1.%2, build %3.</source>
        <translation>Версия ПО %1.%2, сборка %3.</translation>
    </message>
    <message>
        <source>Packets of accelerations do not follow each other.</source>
        <translation>Пакеты ускорений не следуют друг за другом.</translation>
    </message>
</context>
<context>
    <name>AppendFile</name>
    <message>
        <source>the folder %1 cannot be created</source>
        <translation>не удаётся создать папку %1</translation>
    </message>
</context>
<context>
    <name>Ind3Driver</name>
    <message>
        <source>The protocol &quot;%1&quot; is not known; 2.11 is used</source>
        <translation>Протокол «%1» неизвестен; используется 2.11</translation>
    </message>
</context>
<context>
    <name>Modbus</name>
    <message>
        <source>Another program uses this port. Stop that program or choose another IPPort1.</source>
        <translation>Этот порт занят другой программой. Завершите её или выберите другой IPPort1.</translation>
    </message>
    <message>
        <source>Ports below 1024 need a right. Choose another IPPort1, or give the right once: sudo setcap cap_net_bind_service=+ep %1</source>
        <translation>Для портов ниже 1024 нужно право. Выберите другой IPPort1 или дайте право один раз: sudo setcap cap_net_bind_service=+ep %1</translation>
    </message>
    <message>
        <source>This computer does not have the address given in ModbusBind.</source>
        <translation>У этого компьютера нет адреса, указанного в ModbusBind.</translation>
    </message>
    <message>
        <source>Check IPPort1 and ModbusBind.</source>
        <translation>Проверьте IPPort1 и ModbusBind.</translation>
    </message>
    <message>
        <source>Modbus TCP: serving on port %1.</source>
        <translation>Modbus TCP: сервер работает на порту %1.</translation>
    </message>
    <message>
        <source>Modbus TCP: stopped.</source>
        <translation>Modbus TCP: сервер остановлен.</translation>
    </message>
    <message>
        <source>Modbus TCP: cannot serve on port %1 (%2). %3 Trying again every %4 s.</source>
        <translation>Modbus TCP: порт %1 недоступен (%2). %3 Попытки повторяются каждые %4 с.</translation>
    </message>
    <message>
        <source>Modbus TCP: &quot;%1&quot; in ModbusBind is not an IP address. Not serving until it is corrected.</source>
        <translation>Modbus TCP: «%1» в ModbusBind — не IP-адрес. Сервер не работает, пока он не исправлен.</translation>
    </message>
    <message>
        <source>Modbus TCP: &quot;%1&quot; in ModbusAllow is neither an address nor a block of addresses. It is left out.</source>
        <translation>Modbus TCP: «%1» в ModbusAllow — не адрес и не блок адресов. Значение пропущено.</translation>
    </message>
    <message>
        <source>Modbus TCP: %1 sensors, the first of them N=%2, find no room below register 65536 and are not served.</source>
        <translation>Modbus TCP: датчики (%1, первый из них N=%2) не умещаются до регистра 65536 и не передаются.</translation>
    </message>
    <message>
        <source>Modbus TCP: new clients cannot be accepted (%1). Those connected are served on. Trying again every second.</source>
        <translation>Modbus TCP: новые клиенты не принимаются (%1). Подключённые обслуживаются. Попытки повторяются каждую секунду.</translation>
    </message>
    <message>
        <source>Modbus TCP: new clients are accepted again.</source>
        <translation>Modbus TCP: новые клиенты снова принимаются.</translation>
    </message>
    <message>
        <source>Modbus client %1 connected.</source>
        <translation>Клиент Modbus %1 подключился.</translation>
    </message>
    <message>
        <source>Modbus client %1 has not been here since %2.</source>
        <translation>Клиента Modbus %1 не было с %2.</translation>
    </message>
    <message>
        <source>Modbus client %1 was refused: ModbusAllow does not list it.</source>
        <translation>Клиенту Modbus %1 отказано: его нет в ModbusAllow.</translation>
    </message>
    <message>
        <source>Modbus client %1 was disconnected: it does not speak Modbus TCP (wrong length of a request).</source>
        <translation>Клиент Modbus %1 отключён: его запросы не по протоколу Modbus TCP (неверная длина).</translation>
    </message>
    <message>
        <source>Modbus client %1 was disconnected: it asks and does not read the answers.</source>
        <translation>Клиент Modbus %1 отключён: он запрашивает, но не читает ответы.</translation>
    </message>
    <message>
        <source>Modbus client %1 was disconnected: it asked nothing for longer than ModbusIdle.</source>
        <translation>Клиент Modbus %1 отключён: не было запросов дольше ModbusIdle.</translation>
    </message>
    <message>
        <source>Modbus client %1 was disconnected to make room: as many clients as ModbusClients allows, and it was silent the longest.</source>
        <translation>Клиент Modbus %1 отключён, чтобы освободить место: клиентов столько, сколько разрешает ModbusClients, а он молчал дольше всех.</translation>
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
    <name>ServerConfig</name>
    <message>
        <source>%1 is the port of [%2] already.</source>
        <translation>%1 уже занят секцией [%2].</translation>
    </message>
    <message>
        <source>The port is switched off.</source>
        <translation>Порт выключен.</translation>
    </message>
    <message>
        <source>Number %1 belongs to sensor %2 of [%3].</source>
        <translation>Номер %1 уже у датчика %2 секции [%3].</translation>
    </message>
    <message>
        <source>The sensor is listed as number %1.</source>
        <translation>Датчик показан под номером %1.</translation>
    </message>
    <message>
        <source>The sensor is switched off and listed as number %1.</source>
        <translation>Датчик выключен и показан под номером %1.</translation>
    </message>
    <message>
        <source>Address %1 is that of sensor %2 on this port already.</source>
        <translation>Адрес %1 на этом порту уже у датчика %2.</translation>
    </message>
    <message>
        <source>Sensor %1 is switched off.</source>
        <translation>Датчик %1 выключен.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>строка %1</translation>
    </message>
    <message>
        <source>… and %1 more.</source>
        <translation>… и ещё %1.</translation>
    </message>
    <message>
        <source>%1 is not tcp://host:port.</source>
        <translation>%1 — не tcp://узел:порт.</translation>
    </message>
    <message>
        <source>%1 is no kind of device that is known.</source>
        <translation>%1 — неизвестный вид устройства.</translation>
    </message>
    <message>
        <source>NumOfPorts is %1, but at most %2 are possible.</source>
        <translation>NumOfPorts равно %1, но возможно не более %2.</translation>
    </message>
    <message>
        <source>Only the first %1 are used.</source>
        <translation>Используются только первые %1.</translation>
    </message>
    <message>
        <source>NumOfPorts does not count this section.</source>
        <translation>NumOfPorts не учитывает эту секцию.</translation>
    </message>
    <message>
        <source>It is ignored.</source>
        <translation>Она пропущена.</translation>
    </message>
    <message>
        <source>There is no section [%1].</source>
        <translation>Нет секции [%1].</translation>
    </message>
    <message>
        <source>The port is left out.</source>
        <translation>Порт пропущен.</translation>
    </message>
    <message>
        <source>%1 is less than %2.</source>
        <translation>%1 меньше %2.</translation>
    </message>
    <message>
        <source>%1 is outside %2…%3.</source>
        <translation>%1 вне диапазона %2…%3.</translation>
    </message>
    <message>
        <source>%1 is not a whole number.</source>
        <translation>%1 — не целое число.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 — не число.</translation>
    </message>
    <message>
        <source>There is no value.</source>
        <translation>Нет значения.</translation>
    </message>
    <message>
        <source>%1 is none of %2.</source>
        <translation>%1 — не одно из: %2.</translation>
    </message>
    <message>
        <source>The default %1 is used.</source>
        <translation>Используется значение по умолчанию %1.</translation>
    </message>
    <message>
        <source>The sensor is listed under a free number.</source>
        <translation>Датчик показан под свободным номером.</translation>
    </message>
    <message>
        <source>The sensor is switched off.</source>
        <translation>Датчик выключен.</translation>
    </message>
    <message>
        <source>The name of sensor %1 says no type of sensor.</source>
        <translation>В имени датчика %1 не указан тип датчика.</translation>
    </message>
    <message>
        <source>NumOfSensors is %1, but at most %2 are possible.</source>
        <translation>NumOfSensors равно %1, но возможно не более %2.</translation>
    </message>
    <message>
        <source>NumOfSensors is %1, but these have neither adr nor Name: %2.</source>
        <translation>NumOfSensors равно %1, но нет ни adr, ни Name у датчиков: %2.</translation>
    </message>
    <message>
        <source>They are left out.</source>
        <translation>Они пропущены.</translation>
    </message>
    <message>
        <source>NumOfSensors is %1, but %2 more are listed.</source>
        <translation>NumOfSensors равно %1, но описано ещё %2.</translation>
    </message>
    <message>
        <source>They are ignored.</source>
        <translation>Они пропущены.</translation>
    </message>
    <message>
        <source>CanOPCDA=1 allows one copy of the program only.</source>
        <translation>CanOPCDA=1 допускает только одну копию программы.</translation>
    </message>
    <message>
        <source>CanCopy=0 is used.</source>
        <translation>Используется CanCopy=0.</translation>
    </message>
    <message>
        <source>The defaults of all its settings are used.</source>
        <translation>Для всех её настроек используются значения по умолчанию.</translation>
    </message>
    <message>
        <source>The file has no sections.</source>
        <translation>В файле нет секций.</translation>
    </message>
    <message>
        <source>The defaults of all settings are used, nothing is polled.</source>
        <translation>Для всех настроек используются значения по умолчанию, опроса нет.</translation>
    </message>
    <message>
        <source>There is no section [Common].</source>
        <translation>Нет секции [Common].</translation>
    </message>
    <message>
        <source>The line stands before the first section.</source>
        <translation>Строка стоит до первой секции.</translation>
    </message>
    <message>
        <source>All settings before the first section are ignored.</source>
        <translation>Все настройки до первой секции пропущены.</translation>
    </message>
    <message>
        <source>The section begins in line %1 already.</source>
        <translation>Секция уже начата в строке %1.</translation>
    </message>
    <message>
        <source>Of a key in both, the first one counts.</source>
        <translation>Из одинаковых ключей действует первый.</translation>
    </message>
    <message>
        <source>The key stands in line %1 already.</source>
        <translation>Ключ уже есть в строке %1.</translation>
    </message>
    <message>
        <source>The first one counts.</source>
        <translation>Действует первый.</translation>
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
        <source>yes</source>
        <translation>да</translation>
    </message>
    <message>
        <source>no</source>
        <translation>нет</translation>
    </message>
</context>
<context>
    <name>gorizont::And3Dialog</name>
    <message>
        <source>Nothing was written that needs a reset. Restart sensor %1? Its memory of samples is lost.</source>
        <translation>Сброс не требуется: ничего не записано. Перезапустить датчик %1? Накопленные в нём измерения будут потеряны.</translation>
    </message>
    <message>
        <source>&amp;Restart</source>
        <translation>&amp;Перезапустить</translation>
    </message>
    <message>
        <source>Sensor %1 restarts with its new address %2; nobody has seen it there yet. Leave all the same?</source>
        <translation>Датчик %1 перезапускается с новым адресом %2, но ещё не проверено, что он отвечает. Всё равно выйти?</translation>
    </message>
    <message>
        <source>The new address %2 of sensor %1 is stored, but it holds only after a system reset. Leave without it?</source>
        <translation>Новый адрес %2 датчика %1 записан, но вступит в силу только после сброса системы. Выйти без сброса?</translation>
    </message>
    <message>
        <source>Reading sensor %1…</source>
        <translation>Чтение параметров датчика %1…</translation>
    </message>
    <message>
        <source>Sensor %1 cannot be read: %2.</source>
        <translation>Параметры датчика %1 не прочитаны: %2.</translation>
    </message>
    <message>
        <source>new address %1</source>
        <translation>новый адрес %1</translation>
    </message>
    <message>
        <source>Writing: %1…</source>
        <translation>Запись: %1…</translation>
    </message>
    <message>
        <source>new address %1 stored, it holds after a system reset</source>
        <translation>новый адрес %1 записан, вступит в силу после сброса системы</translation>
    </message>
    <message>
        <source>Sensor %1: %2</source>
        <translation>Датчик %1: %2</translation>
    </message>
    <message>
        <source>The new address %1 is stored in the sensor. Press &lt;System reset&gt; so that the sensor takes it.</source>
        <translation>Новый адрес %1 записан в датчик. Чтобы он вступил в силу, нажмите &lt;Сброс системы&gt;.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>ОК</translation>
    </message>
    <message>
        <source>system reset</source>
        <translation>сброс системы</translation>
    </message>
    <message>
        <source>The sensor restarts…</source>
        <translation>Датчик перезапускается…</translation>
    </message>
    <message>
        <source>system reset sent</source>
        <translation>команда сброса системы отправлена</translation>
    </message>
    <message>
        <source>system reset not sent: %1</source>
        <translation>команда сброса системы не отправлена: %1</translation>
    </message>
    <message>
        <source>the sensor answers at its new address %1</source>
        <translation>датчик отвечает по новому адресу %1</translation>
    </message>
    <message>
        <source>the sensor still answers at its old address after the reset. Write the new one again.</source>
        <translation>после сброса датчик отвечает по прежнему адресу. Запишите новый адрес ещё раз.</translation>
    </message>
    <message>
        <source>the sensor answers neither at %1 nor at %2 after the reset. Scan again; check its power.</source>
        <translation>после сброса датчик не отвечает ни по адресу %1, ни по адресу %2. Повторите сканирование, проверьте питание.</translation>
    </message>
</context>
<context>
    <name>gorizont::And3Form</name>
    <message>
        <source>Exchange</source>
        <translation>Параметры обмена</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Изменить</translation>
    </message>
    <message>
        <source>The address of %1 is changed in the group &lt;System&gt;.</source>
        <translation>Адрес %1 изменяется в группе &lt;Система&gt;.</translation>
    </message>
    <message>
        <source>&amp;Address on the line:</source>
        <translation>&amp;Адрес на линии:</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Данные</translation>
    </message>
    <message>
        <source>Temperature, °C:</source>
        <translation>Температура, °C:</translation>
    </message>
    <message>
        <source>Tilt X, Y, ″:</source>
        <translation>Наклон X, Y, ″:</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Система</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>За&amp;пись</translation>
    </message>
    <message>
        <source>System &amp;reset</source>
        <translation>Сброс с&amp;истемы</translation>
    </message>
    <message>
        <source>Restarts the controller of the sensor, about five seconds. Its memory of samples is lost.</source>
        <translation>Перезапускает контроллер датчика, около пяти секунд. Накопленные в датчике измерения теряются.</translation>
    </message>
    <message>
        <source>Set a &amp;new address:</source>
        <translation>За&amp;дать новый адр.:</translation>
    </message>
    <message>
        <source>Current address:</source>
        <translation>Текущий адрес:</translation>
    </message>
    <message>
        <source>Firmware:</source>
        <translation>Версия ПО:</translation>
    </message>
    <message>
        <source>Addresses where nobody answered</source>
        <translation>Адреса, по которым никто не ответил</translation>
    </message>
    <message>
        <source>The address can be changed only after a complete scan that was not stopped.</source>
        <translation>Изменить адрес можно только после полного сканирования, без остановки.</translation>
    </message>
</context>
<context>
    <name>gorizont::Application</name>
    <message>
        <source>Gorizont Server %1 started</source>
        <translation>Gorizont Server %1 запущен</translation>
    </message>
    <message>
        <source>Another copy of the program writes into %1: this copy does not save. Give it a folder of its own.</source>
        <translation>В %1 пишет другая копия программы: эта копия не сохраняет. Задайте ей отдельную папку.</translation>
    </message>
    <message>
        <source>Modbus TCP: port %1</source>
        <translation>Modbus TCP: порт %1</translation>
    </message>
    <message>
        <source>Modbus TCP: port %1 cannot be used</source>
        <translation>Modbus TCP: порт %1 недоступен</translation>
    </message>
    <message>
        <source>Modbus TCP: off</source>
        <translation>Modbus TCP: выключен</translation>
    </message>
    <message>
        <source>Gorizont Server ended</source>
        <translation>Gorizont Server завершён</translation>
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
    <name>gorizont::ChangeText</name>
    <message>
        <source>the new address %1 is taken; nothing was stored. Scan again.</source>
        <translation>новый адрес %1 занят; ничего не записано. Повторите сканирование.</translation>
    </message>
    <message>
        <source>asking the sensor before the change failed (%1); nothing was stored</source>
        <translation>проверка датчика перед изменением не удалась (%1); ничего не записано</translation>
    </message>
    <message>
        <source>copying the configuration failed (%1); nothing was stored</source>
        <translation>копирование конфигурации не удалось (%1); ничего не записано</translation>
    </message>
    <message>
        <source>checking the copied configuration failed (%1); nothing was stored</source>
        <translation>проверка копии конфигурации не удалась (%1); ничего не записано</translation>
    </message>
    <message>
        <source>setting the new address %2 failed (%1); nothing was stored</source>
        <translation>установка нового адреса %2 не удалась (%1); ничего не записано</translation>
    </message>
    <message>
        <source>checking the new address %2 failed (%1); nothing was stored</source>
        <translation>проверка нового адреса %2 не удалась (%1); ничего не записано</translation>
    </message>
    <message>
        <source>name “%1”</source>
        <translation>имя «%1»</translation>
    </message>
    <message>
        <source>zero offset X %1″, Y %2″</source>
        <translation>смещение нуля X %1″, Y %2″</translation>
    </message>
    <message>
        <source>averaging ticks %1</source>
        <translation>тактов усреднения %1</translation>
    </message>
    <message>
        <source>averaging period %1 ms</source>
        <translation>период усреднения %1 мс</translation>
    </message>
    <message>
        <source>written</source>
        <translation>записано</translation>
    </message>
    <message>
        <source>not written, the sensor does not take it</source>
        <translation>не записано, датчик не принимает значение</translation>
    </message>
    <message>
        <source>not written, the sensor still has another value</source>
        <translation>не записано, в датчике осталось другое значение</translation>
    </message>
    <message>
        <source>%1: whether it was written is not known, check it</source>
        <translation>%1: записано или нет, неизвестно, проверьте</translation>
    </message>
    <message>
        <source>storing the new address %2 failed (%1); whether it was stored is not known. Write again before a reset.</source>
        <translation>запись нового адреса %2 не удалась (%1); записан ли он, неизвестно. Повторите запись до сброса.</translation>
    </message>
    <message>
        <source>the new address %2 was stored, but checking the stored configuration failed (%1). Write again before a reset.</source>
        <translation>новый адрес %2 записан, но проверка записанной конфигурации не удалась (%1). Повторите запись до сброса.</translation>
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
    <name>gorizont::ConfigFile</name>
    <message>
        <source>the file is far too large to be a configuration</source>
        <translation>файл слишком велик для файла настроек</translation>
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
    <name>gorizont::HistoryFiles</name>
    <message>
        <source>The history is being saved again.</source>
        <translation>Запись истории возобновлена.</translation>
    </message>
    <message>
        <source>The history is not being saved: %1. It is tried again every few seconds.</source>
        <translation>История не сохраняется: %1. Попытки повторяются каждые несколько секунд.</translation>
    </message>
    <message>
        <source>%1 did not end with a whole record; what was unfinished has been removed.</source>
        <translation>%1 заканчивался неполной записью; неполная часть удалена.</translation>
    </message>
</context>
<context>
    <name>gorizont::HistoryWriter</name>
    <message>
        <source>The clock of the computer was set forward by %1 s.</source>
        <translation>Часы компьютера переведены вперёд на %1 с.</translation>
    </message>
    <message>
        <source>The clock of the computer was set back by %1 s.</source>
        <translation>Часы компьютера переведены назад на %1 с.</translation>
    </message>
    <message>
        <source>The disk was busy for too long: %1 samples and %2 events were not saved.</source>
        <translation>Диск был занят слишком долго: не сохранено отсчётов: %1, событий: %2.</translation>
    </message>
</context>
<context>
    <name>gorizont::Ind3Dialog</name>
    <message>
        <source>C&amp;hange</source>
        <translation>&amp;Изменить</translation>
    </message>
    <message>
        <source>Apply the ne&amp;w settings</source>
        <translation>Применить &amp;новые настройки</translation>
    </message>
    <message>
        <source>Only sensors that speak this protocol are found. Another choice begins a new scan.</source>
        <translation>Обнаруживаются только датчики с этим протоколом. При выборе другого начинается новое сканирование.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Н&amp;е применять</translation>
    </message>
    <message>
        <source>Gives the sensor another address</source>
        <translation>Задать датчику другой адрес</translation>
    </message>
    <message>
        <source>The address can be changed only after a complete scan that was not stopped.</source>
        <translation>Изменить адрес можно только после полного сканирования, без остановки.</translation>
    </message>
    <message>
        <source>The new settings of sensor %1 were not applied. Discard them?</source>
        <translation>Новые настройки датчика %1 не применены. Продолжить без них?</translation>
    </message>
    <message>
        <source>Reading sensor %1…</source>
        <translation>Чтение параметров датчика %1…</translation>
    </message>
    <message>
        <source>Sensor %1 cannot be read: %2.</source>
        <translation>Параметры датчика %1 не прочитаны: %2.</translation>
    </message>
    <message>
        <source>The sensor reports that a check sum of its memory is wrong: it needs repair.</source>
        <translation>Датчик сообщает об ошибке контрольной суммы своей памяти: требуется ремонт.</translation>
    </message>
    <message>
        <source>Writing: %1…</source>
        <translation>Запись: %1…</translation>
    </message>
    <message>
        <source>%1, not written</source>
        <translation>%1, не записано</translation>
    </message>
    <message>
        <source>Sensor %1: %2.</source>
        <translation>Датчик %1: %2.</translation>
    </message>
    <message>
        <source>new address %1</source>
        <translation>новый адрес %1</translation>
    </message>
    <message>
        <source>%1, written</source>
        <translation>%1, записано</translation>
    </message>
    <message>
        <source>%1, not written: it is taken, or the sensor will not. Scan again.</source>
        <translation>%1, не записано: адрес занят, или датчик его не принимает. Повторите сканирование.</translation>
    </message>
    <message>
        <source>%1, not written: the sensor still answers at %2</source>
        <translation>%1, не записано: датчик отвечает по прежнему адресу %2</translation>
    </message>
    <message>
        <source>%1, %2: whether it was written is not known. Scan the line to find the sensor.</source>
        <translation>%1, %2: записано или нет, неизвестно. Найдите датчик сканированием.</translation>
    </message>
    <message>
        <source>Sensor %1: %2</source>
        <translation>Датчик %1: %2</translation>
    </message>
</context>
<context>
    <name>gorizont::Ind3Form</name>
    <message>
        <source>Exchange</source>
        <translation>Параметры обмена</translation>
    </message>
    <message>
        <source>Up to %1 characters: Latin, Cyrillic, digits and signs. The sensor keeps the name.</source>
        <translation>До %1 символов: латиница, кириллица, цифры и специальные символы. Имя хранится в датчике.</translation>
    </message>
    <message>
        <source>The speed is shown only; this program does not change it.</source>
        <translation>Скорость обмена только отображается, её изменение не допускается.</translation>
    </message>
    <message>
        <source>&amp;Address on the line:</source>
        <translation>&amp;Адрес на линии:</translation>
    </message>
    <message>
        <source>&amp;Name of the sensor:</source>
        <translation>И&amp;мя измерителя:</translation>
    </message>
    <message>
        <source>Speed:</source>
        <translation>Скорость обмена:</translation>
    </message>
    <message>
        <source>&amp;Protocol:</source>
        <translation>&amp;Протокол обмена:</translation>
    </message>
    <message>
        <source>About the device</source>
        <translation>Об устройстве</translation>
    </message>
    <message>
        <source>Version of the sensor:</source>
        <translation>Версия измерителя:</translation>
    </message>
    <message>
        <source>Software revision:</source>
        <translation>Номер редакции ПО:</translation>
    </message>
    <message>
        <source>Factory number:</source>
        <translation>Заводской номер:</translation>
    </message>
    <message>
        <source>Arc-seconds, from −%1 to +%1. Point and comma are both decimal marks.</source>
        <translation>Угловые секунды, от −%1 до +%1. Дробная часть отделяется точкой или запятой.</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Параметры измерения</translation>
    </message>
    <message>
        <source>Zero offset &amp;X, ″:</source>
        <translation>Смещение нуля &amp;X, ″:</translation>
    </message>
    <message>
        <source>Averaging &amp;ticks:</source>
        <translation>&amp;Тактов усреднения:</translation>
    </message>
    <message>
        <source>Zero offset &amp;Y, ″:</source>
        <translation>Смещение нуля &amp;Y, ″:</translation>
    </message>
    <message>
        <source>Averaging p&amp;eriod, ms:</source>
        <translation>П&amp;ериод усреднения, мс:</translation>
    </message>
    <message>
        <source>Tilt X, Y now, ″:</source>
        <translation>Наклон X, Y сейчас, ″:</translation>
    </message>
    <message>
        <source>Type %1, revision %2</source>
        <translation>Тип %1, редакция %2</translation>
    </message>
    <message>
        <source>The name needs 1…%1 characters: Latin, Cyrillic, digits and signs.</source>
        <translation>Имя: 1…%1 символов, латиница, кириллица, цифры, специальные символы.</translation>
    </message>
    <message>
        <source>An offset is a number from −%1 to +%1.</source>
        <translation>Смещение нуля: число от −%1 до +%1.</translation>
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
    <name>gorizont::LinePoller</name>
    <message>
        <source>%1 works normally again</source>
        <translation>%1 снова работает нормально</translation>
    </message>
</context>
<context>
    <name>gorizont::LineWorker</name>
    <message>
        <source>%1: polling suspended for service</source>
        <translation>%1: опрос приостановлен для настройки</translation>
    </message>
    <message>
        <source>%1: service ended, polling goes on</source>
        <translation>%1: настройка завершена, опрос продолжен</translation>
    </message>
    <message>
        <source>%1 is open</source>
        <translation>%1 открыт</translation>
    </message>
    <message>
        <source>%1 cannot be opened (%2). Check the adapter and its port number; the program keeps trying.</source>
        <translation>%1 не открывается (%2). Проверьте адаптер и номер порта; программа повторяет попытки.</translation>
    </message>
    <message>
        <source>%1 is gone (%2). Check the adapter and its cable; the program opens the port again as soon as it can.</source>
        <translation>%1 пропал (%2). Проверьте адаптер и его кабель; программа откроет порт, как только это станет возможно.</translation>
    </message>
</context>
<context>
    <name>gorizont::Main</name>
    <message>
        <source>Gorizont Server already works with the folder %1. Close that copy, or give this one a folder of its own with --data.</source>
        <translation>Gorizont Server уже работает с папкой %1. Закройте ту копию или задайте этой отдельную папку ключом --data.</translation>
    </message>
    <message>
        <source>There is no GorizontServer.ini. Name one with --config, or look at the program with --demo.</source>
        <translation>Нет файла GorizontServer.ini. Укажите его ключом --config или посмотрите программу с ключом --demo.</translation>
    </message>
    <message>
        <source>There is no display. Start the program with --headless.</source>
        <translation>Нет экрана. Запустите программу с ключом --headless.</translation>
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
    <message>
        <source>&amp;Service</source>
        <translation>С&amp;ервис</translation>
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
    <name>gorizont::NewAddressDialog</name>
    <message>
        <source>New address</source>
        <translation>Новый адрес</translation>
    </message>
    <message>
        <source>Addresses where a sensor was found are not offered.</source>
        <translation>Адреса обнаруженных датчиков не предлагаются.</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Применить</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>О&amp;тмена</translation>
    </message>
    <message>
        <source>Address on the line:</source>
        <translation>Адрес на линии:</translation>
    </message>
    <message>
        <source>&amp;New address:</source>
        <translation>&amp;Новый адрес:</translation>
    </message>
</context>
<context>
    <name>gorizont::Options</name>
    <message>
        <source>The configuration, GorizontServer.ini.</source>
        <translation>Файл настроек GorizontServer.ini.</translation>
    </message>
    <message>
        <source>Where History goes; default: the folder of the ini.</source>
        <translation>Папка для History; по умолчанию — папка файла настроек.</translation>
    </message>
    <message>
        <source>Port number n is opened as DIR/COMn.</source>
        <translation>Порт с номером n открывается как DIR/COMn.</translation>
    </message>
    <message>
        <source>No window; ends on SIGINT or SIGTERM.</source>
        <translation>Без окна; завершается по SIGINT или SIGTERM.</translation>
    </message>
    <message>
        <source>A simulated building, no files to prepare.</source>
        <translation>Имитация здания, файлы готовить не нужно.</translation>
    </message>
    <message>
        <source>Language of the program.</source>
        <translation>Язык программы.</translation>
    </message>
    <message>
        <source>Prints each new reading as one line of JSON.</source>
        <translation>Печатать каждое новое показание строкой JSON.</translation>
    </message>
    <message>
        <source>Prints this.</source>
        <translation>Показать эту справку.</translation>
    </message>
    <message>
        <source>Prints the version.</source>
        <translation>Показать версию.</translation>
    </message>
    <message>
        <source>Polls inclinometers and accelerometers, shows, saves and serves their readings.</source>
        <translation>Опрашивает инклинометры и акселерометры, показывает, сохраняет и передаёт их показания.</translation>
    </message>
    <message>
        <source>Unexpected argument: %1</source>
        <translation>Лишний аргумент: %1</translation>
    </message>
    <message>
        <source>--lang takes ru or en, not %1</source>
        <translation>--lang принимает ru или en, а не %1</translation>
    </message>
    <message>
        <source>--demo brings its own configuration; leave --config away</source>
        <translation>--demo использует свои настройки; уберите --config</translation>
    </message>
</context>
<context>
    <name>gorizont::PortGroup</name>
    <message>
        <source>COM port</source>
        <translation>COM-порт</translation>
    </message>
    <message>
        <source>Number:</source>
        <translation>Номер:</translation>
    </message>
    <message>
        <source>Speed:</source>
        <translation>Скорость обмена:</translation>
    </message>
    <message>
        <source>The configuration file decides about the port.</source>
        <translation>Параметры порта определяет файл конфигурации.</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Закрыть</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Открыть</translation>
    </message>
    <message>
        <source>Ends service: the sensors of the port are polled again. The window stays.</source>
        <translation>Завершает сервисный режим: опрос датчиков порта продолжается. Окно остаётся открытым.</translation>
    </message>
    <message>
        <source>Takes the port into service again and scans it.</source>
        <translation>Снова переводит порт в сервисный режим и сканирует линию.</translation>
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
    <name>gorizont::ScanPanel</name>
    <message>
        <source>Sensors found on the line:</source>
        <translation>Всего обнаружено датчиков на линии:</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>О&amp;становить</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>&amp;Сканировать</translation>
    </message>
    <message>
        <source>Address %1 of %2 is asked.</source>
        <translation>Опрашивается адрес %1 из %2.</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>Обнаружены: %1.</translation>
    </message>
    <message>
        <source>Unclear: %1. Somebody answers there, but the answers are damaged: two sensors with one address look like that. Disconnect one of them and scan again.</source>
        <translation>Неясно: %1. Оттуда приходят повреждённые ответы: так выглядят два датчика с одним адресом. Отключите один из них и повторите сканирование.</translation>
    </message>
    <message>
        <source>Nobody answers. Check power, cable and speed.</source>
        <translation>Никто не отвечает. Проверьте питание, кабель и скорость обмена.</translation>
    </message>
    <message>
        <source>The scan is not complete: a sensor cannot get a new address before all %1 addresses were asked.</source>
        <translation>Сканирование неполное: изменить адрес датчика можно, когда опрошены все %1 адресов.</translation>
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
    <name>gorizont::SerialLine</name>
    <message>
        <source>there is no such device</source>
        <translation>нет такого устройства</translation>
    </message>
</context>
<context>
    <name>gorizont::ServiceDesk</name>
    <message>
        <source>Select a port in the tree first.</source>
        <translation>Сначала выберите порт в дереве.</translation>
    </message>
    <message>
        <source>The port is off (On=0).</source>
        <translation>Порт выключен (On=0).</translation>
    </message>
    <message>
        <source>The port is in service already.</source>
        <translation>Порт уже в сервисном режиме.</translation>
    </message>
    <message>
        <source>The port is not open.</source>
        <translation>Порт не открыт.</translation>
    </message>
    <message>
        <source>There is no %1 in the list of this port.</source>
        <translation>В списке датчиков этого порта нет %1.</translation>
    </message>
    <message>
        <source>%1 goes into service mode: the monitoring of all its sensors is suspended.</source>
        <translation>%1 переводится в сервисный режим: мониторинг всех его датчиков приостанавливается.</translation>
    </message>
    <message>
        <source>Until the service window is closed, screens, files and clients keep the last values, marked as not valid. The other ports go on.</source>
        <translation>Пока окно настройки открыто, на экране, в файлах и у клиентов остаются последние значения с признаком недостоверности. Остальные порты работают.</translation>
    </message>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;ОК</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>О&amp;тмена</translation>
    </message>
</context>
<context>
    <name>gorizont::ServiceDialog</name>
    <message>
        <source>%1, the program ended before the answer came: whether it was written is not known, check it</source>
        <translation>%1, программа завершилась до ответа датчика: записано или нет, неизвестно, проверьте</translation>
    </message>
    <message>
        <source>The port goes into service mode…</source>
        <translation>Порт переводится в сервисный режим…</translation>
    </message>
    <message>
        <source>The window closes as soon as the sensor has answered.</source>
        <translation>Окно закроется, как только датчик ответит.</translation>
    </message>
    <message>
        <source>&amp;Leave</source>
        <translation>В&amp;ыйти</translation>
    </message>
    <message>
        <source>Service has ended, the sensors of the port are polled again.</source>
        <translation>Сервисный режим завершён, опрос датчиков порта продолжается.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Н&amp;е применять</translation>
    </message>
    <message>
        <source>%1, %2 address %3: %4</source>
        <translation>%1, %2 адрес %3: %4</translation>
    </message>
    <message>
        <source>Ex&amp;it</source>
        <translation>&amp;Выход</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Верн&amp;уться</translation>
    </message>
</context>
<context>
    <name>gorizont::ServiceSession</name>
    <message>
        <source>The port is in service already.</source>
        <translation>Порт уже в сервисном режиме.</translation>
    </message>
    <message>
        <source>The program is about to end.</source>
        <translation>Программа завершает работу.</translation>
    </message>
    <message>
        <source>The port is not open. Check the adapter and its cable.</source>
        <translation>Порт не открыт. Проверьте адаптер и кабель.</translation>
    </message>
    <message>
        <source>%1 is gone (%2). Service has ended; polling goes on as soon as the port is back.</source>
        <translation>%1 пропал (%2). Сервисный режим завершён; опрос продолжится, когда порт появится.</translation>
    </message>
</context>
<context>
    <name>gorizont::ServiceText</name>
    <message>
        <source>no answer</source>
        <translation>нет ответа</translation>
    </message>
    <message>
        <source>the answers are damaged</source>
        <translation>ответы повреждены</translation>
    </message>
    <message>
        <source>the answer is not the expected one</source>
        <translation>ответ не тот, что ожидался</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>отказ</translation>
    </message>
    <message>
        <source>the port is gone</source>
        <translation>порт пропал</translation>
    </message>
    <message>
        <source>broken off</source>
        <translation>прервано</translation>
    </message>
    <message>
        <source>Settings of %1 sensors</source>
        <translation>Настройка датчиков %1</translation>
    </message>
    <message>
        <source>Settings of %1 sensors on %2</source>
        <translation>Настройка датчиков %1 на %2</translation>
    </message>
    <message>
        <source>No sensor of the configuration file has this address; add one to [Port%1] so that it is polled.</source>
        <translation>В файле конфигурации нет датчика с прежним адресом; чтобы датчик опрашивался, добавьте его в [Port%1].</translation>
    </message>
    <message>
        <source>Write adr%2=%3 into [Port%1] of the configuration file and start the program again: until then it polls address %4.</source>
        <translation>Исправьте в файле конфигурации [Port%1] adr%2=%3 и перезапустите программу: до этого она опрашивает адрес %4.</translation>
    </message>
    <message>
        <source>%1 (N %2 in the ini)</source>
        <translation>%1 (в ini: N %2)</translation>
    </message>
</context>
<context>
    <name>gorizont::Simulator</name>
    <message>
        <source>Plays the sensors of an ini file: every port becomes a pty linked as DIR/COMn.

Faults, each KIND=VALUE[@FROM[-TO]] with times in seconds since the start:
  silent=N     the sensor with site number N does not answer
  crc=P        P % of the answers have a wrong byte
  garbage=P    P % of the answers come after garbage
  pieces=P     P % of the answers come in pieces
  late=P       P % of the answers come 1.5 s late
  reboot=N     the sensor N restarts, once at FROM
  overrun=N    the ring of the sensor N is overwritten, once at FROM
  gone=n:S     the port COMn is gone for S seconds, once at FROM</source>
        <translation>Имитирует датчики файла настроек: каждый порт становится псевдотерминалом со ссылкой DIR/COMn.

Неисправности, каждая KIND=VALUE[@FROM[-TO]], время в секундах от запуска:
  silent=N     датчик с номером N на объекте не отвечает
  crc=P        P % ответов с неверным байтом
  garbage=P    P % ответов приходят после мусора
  pieces=P     P % ответов приходят по частям
  late=P       P % ответов опаздывают на 1,5 с
  reboot=N     датчик N перезагружается один раз в момент FROM
  overrun=N    буфер датчика N перезаписывается один раз в момент FROM
  gone=n:S     порт COMn пропадает на S секунд один раз в момент FROM</translation>
    </message>
    <message>
        <source>The ini that lists the sensors.</source>
        <translation>Файл настроек со списком датчиков.</translation>
    </message>
    <message>
        <source>Folder for the links COMn.</source>
        <translation>Папка для ссылок COMn.</translation>
    </message>
    <message>
        <source>Another building.</source>
        <translation>Другое здание.</translation>
    </message>
    <message>
        <source>Something that goes wrong.</source>
        <translation>Неисправность.</translation>
    </message>
    <message>
        <source>--config FILE and --ports DIR are needed</source>
        <translation>нужны --config FILE и --ports DIR</translation>
    </message>
    <message>
        <source>--fault %1 is not understood; --help lists what can go wrong</source>
        <translation>--fault %1 непонятно; --help перечисляет неисправности</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>не удаётся создать папку %1</translation>
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
    <name>gorizont::Startup</name>
    <message>
        <source>%1 cannot be read (%2). Check the name and the rights of the file.</source>
        <translation>Не удаётся прочитать %1 (%2). Проверьте имя и права доступа к файлу.</translation>
    </message>
    <message>
        <source>The folder %1 for the data cannot be made. Choose another one with --data.</source>
        <translation>Не удаётся создать папку данных %1. Задайте другую ключом --data.</translation>
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
    <name>gorizont::StatusText</name>
    <message>
        <source>%1 No. %2 (%3, address %4)</source>
        <translation>%1 № %2 (%3, адрес %4)</translation>
    </message>
    <message>
        <source>No errors</source>
        <translation>Нет ошибок</translation>
    </message>
    <message>
        <source>The port is off</source>
        <translation>Порт выключен</translation>
    </message>
    <message>
        <source>Port error</source>
        <translation>Ошибка порта</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Не отвечает</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>Ошибки CRC</translation>
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
        <translation>Первичный преобразователь вне диапазона</translation>
    </message>
    <message>
        <source>The temperature sensor does not work</source>
        <translation>Не работает датчик температуры</translation>
    </message>
    <message>
        <source>The temperature sensor is out of range</source>
        <translation>Датчик температуры вне диапазона</translation>
    </message>
    <message>
        <source>The fan does not work</source>
        <translation>Не работает вентилятор</translation>
    </message>
    <message>
        <source>The thermostat takes too long to settle</source>
        <translation>Время установления температуры термостата превысило допустимое</translation>
    </message>
    <message>
        <source>Unknown error</source>
        <translation>Неизвестная ошибка</translation>
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
