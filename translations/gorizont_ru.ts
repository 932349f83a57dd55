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
    <message>
        <source>Modbus TCP: %1 sensors, the first of them N=%2, find no room below register 65536 in unit %3 and are not served there.</source>
        <translation>Modbus TCP: датчикам (%1 шт., первый из них N=%2) не хватает места ниже регистра 65536 в устройстве %3, там они не передаются.</translation>
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
    <name>RegisterMap</name>
    <message>
        <source>Channel word: two bits a port</source>
        <translation>Слово состояния канала: два бита на порт</translation>
    </message>
    <message>
        <source>mm/s²</source>
        <translation>мм/с²</translation>
    </message>
    <message>
        <source>Largest acceleration, modulus</source>
        <translation>Максимальное ускорение, модуль</translation>
    </message>
    <message>
        <source>Direction of the largest acceleration</source>
        <translation>Направление максимального ускорения</translation>
    </message>
    <message>
        <source>RMS of the acceleration along X</source>
        <translation>СКО ускорения по X</translation>
    </message>
    <message>
        <source>RMS of the acceleration along Y</source>
        <translation>СКО ускорения по Y</translation>
    </message>
    <message>
        <source>Status word of the sensor</source>
        <translation>Слово состояния датчика</translation>
    </message>
    <message>
        <source>Accelerations</source>
        <translation>Ускорения</translation>
    </message>
    <message>
        <source>What is not valid keeps its last value, 0 if it never had one; the status word says so.</source>
        <translation>Недостоверное значение остаётся последним известным, до первого измерения оно равно 0; об этом говорит слово состояния.</translation>
    </message>
    <message>
        <source>the slot belongs to a sensor</source>
        <translation>место занято датчиком</translation>
    </message>
    <message>
        <source>the sensor is switched on</source>
        <translation>датчик включён</translation>
    </message>
    <message>
        <source>its port is switched on</source>
        <translation>его порт включён</translation>
    </message>
    <message>
        <source>it answers</source>
        <translation>датчик отвечает</translation>
    </message>
    <message>
        <source>tilt is valid</source>
        <translation>углы наклона достоверны</translation>
    </message>
    <message>
        <source>temperature is valid</source>
        <translation>температура достоверна</translation>
    </message>
    <message>
        <source>accelerations are valid</source>
        <translation>ускорения достоверны</translation>
    </message>
    <message>
        <source>raw_status holds a word</source>
        <translation>raw_status содержит слово</translation>
    </message>
    <message>
        <source>raw_mode holds a word</source>
        <translation>raw_mode содержит слово</translation>
    </message>
    <message>
        <source>packets of samples are counted</source>
        <translation>пакеты отсчётов подсчитываются</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>углы наклона</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>температура</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>ускорения</translation>
    </message>
    <message>
        <source>thermostat</source>
        <translation>термостат</translation>
    </message>
    <message>
        <source>no type, never polled</source>
        <translation>тип не указан, не опрашивается</translation>
    </message>
    <message>
        <source>IN-D2, IN-D3, IN-D7, IN-D9</source>
        <translation>ИН-Д2, ИН-Д3, ИН-Д7, ИН-Д9</translation>
    </message>
    <message>
        <source>AN-D3</source>
        <translation>АН-Д3</translation>
    </message>
    <message>
        <source>USM-ISN</source>
        <translation>УСМ-ИСН</translation>
    </message>
    <message>
        <source>L-VIMS</source>
        <translation>L-VIMS</translation>
    </message>
    <message>
        <source>MK-14</source>
        <translation>МК-14</translation>
    </message>
    <message>
        <source>How many sensors have this status code</source>
        <translation>Сколько датчиков с этим кодом состояния</translation>
    </message>
    <message>
        <source>474F525Ah, the letters GORZ: this is the map</source>
        <translation>474F525Ah, буквы GORZ: признак этой карты</translation>
    </message>
    <message>
        <source>Version of the layout</source>
        <translation>Версия карты</translation>
    </message>
    <message>
        <source>How many slots there are</source>
        <translation>Сколько всего мест</translation>
    </message>
    <message>
        <source>Register where the directory starts</source>
        <translation>Регистр, с которого начинается каталог</translation>
    </message>
    <message>
        <source>Registers of an entry of the directory</source>
        <translation>Регистров в записи каталога</translation>
    </message>
    <message>
        <source>Register where the block of slot 0 starts</source>
        <translation>Регистр, с которого начинается блок места 0</translation>
    </message>
    <message>
        <source>Registers of a block</source>
        <translation>Регистров в блоке</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>Time of the answer, UTC, since 1970</source>
        <translation>Время ответа, UTC, от 1970 г.</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>Since the program started</source>
        <translation>От запуска программы</translation>
    </message>
    <message>
        <source>How many sensors there are</source>
        <translation>Сколько всего датчиков</translation>
    </message>
    <message>
        <source>How many of them answer</source>
        <translation>Сколько из них отвечают</translation>
    </message>
    <message>
        <source>How many of them are switched off</source>
        <translation>Сколько из них выключено</translation>
    </message>
    <message>
        <source>Site number N; 0: an empty slot</source>
        <translation>Номер датчика N; 0 – место пустое</translation>
    </message>
    <message>
        <source>Flags of the slot</source>
        <translation>Флаги места</translation>
    </message>
    <message>
        <source>Number of the port in the ini, 1…16</source>
        <translation>Номер порта в ini, 1…16</translation>
    </message>
    <message>
        <source>Address on the line</source>
        <translation>Адрес на линии</translation>
    </message>
    <message>
        <source>Type of the sensor</source>
        <translation>Тип датчика</translation>
    </message>
    <message>
        <source>What the sensor measures</source>
        <translation>Что измеряет датчик</translation>
    </message>
    <message>
        <source>The sensor&apos;s own status word</source>
        <translation>Собственное слово состояния датчика</translation>
    </message>
    <message>
        <source>The sensor&apos;s own mode word</source>
        <translation>Собственное слово режима датчика</translation>
    </message>
    <message>
        <source>Since the last answer; FFFFFFFFh: none so far</source>
        <translation>От последнего ответа; FFFFFFFFh – ответа не было</translation>
    </message>
    <message>
        <source>Time of the last answer, UTC, since 1970; 0: none so far</source>
        <translation>Время последнего ответа, UTC, от 1970 г.; 0 – ответа не было</translation>
    </message>
    <message>
        <source>Tilt along X</source>
        <translation>Угол наклона по X</translation>
    </message>
    <message>
        <source>Tilt along Y</source>
        <translation>Угол наклона по Y</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Температура</translation>
    </message>
    <message>
        <source>Power of the heater</source>
        <translation>Мощность нагревателя</translation>
    </message>
    <message>
        <source>1/s</source>
        <translation>1/с</translation>
    </message>
    <message>
        <source>Speed of the fan</source>
        <translation>Частота вращения вентилятора</translation>
    </message>
    <message>
        <source>Component of the largest acceleration along X</source>
        <translation>Составляющая максимального ускорения по X</translation>
    </message>
    <message>
        <source>Component of the largest acceleration along Y</source>
        <translation>Составляющая максимального ускорения по Y</translation>
    </message>
    <message>
        <source>RMS of the acceleration, modulus</source>
        <translation>СКО ускорения, модуль</translation>
    </message>
    <message>
        <source>Answers since the program started</source>
        <translation>Ответов от запуска программы</translation>
    </message>
    <message>
        <source>Failed reads since the program started</source>
        <translation>Ошибок чтения от запуска программы</translation>
    </message>
    <message>
        <source>Wrong check sums since the program started</source>
        <translation>Ошибок CRC от запуска программы</translation>
    </message>
    <message>
        <source>Packets of samples measured since the sensor started</source>
        <translation>Пакетов отсчётов измерено от запуска датчика</translation>
    </message>
    <message>
        <source>Packets of samples read since the program started</source>
        <translation>Пакетов отсчётов прочитано от запуска программы</translation>
    </message>
    <message>
        <source>Between the last two turns</source>
        <translation>Период двух последних опросов</translation>
    </message>
    <message>
        <source>How long the last turn took</source>
        <translation>Длительность последнего опроса</translation>
    </message>
    <message>
        <source>Directory</source>
        <translation>Каталог</translation>
    </message>
    <message>
        <source>Blocks of the sensors</source>
        <translation>Блоки датчиков</translation>
    </message>
    <message>
        <source>Extended map: every sensor of every type</source>
        <translation>Расширенная карта: все датчики всех типов</translation>
    </message>
    <message>
        <source>A number that is absent or not valid now is NaN (7FC00000h) where the type is float32, and 0 with a flag otherwise. Registers that are not listed are reserved and read 0. One request is answered from one moment: a value that it reads whole is never torn.</source>
        <translation>Отсутствующее или недостоверное сейчас число типа float32 равно NaN (7FC00000h), у остальных типов – 0, о чём говорит флаг. Не перечисленные регистры зарезервированы и читаются как 0. Ответ на один запрос относится к одному моменту: прочитанное целиком значение не бывает составлено из двух разных.</translation>
    </message>
    <message>
        <source>Bit</source>
        <translation>Бит</translation>
    </message>
    <message>
        <source>If it is set</source>
        <translation>Если установлен</translation>
    </message>
    <message>
        <source>the sensor is switched off</source>
        <translation>датчик выключен</translation>
    </message>
    <message>
        <source>tilt is not valid or not ready</source>
        <translation>углы наклона не достоверны или не готовы</translation>
    </message>
    <message>
        <source>temperature is not valid or not ready</source>
        <translation>температура не достоверна или не готова</translation>
    </message>
    <message>
        <source>accelerations are not valid or not ready</source>
        <translation>ускорения не достоверны или не готовы</translation>
    </message>
    <message>
        <source>samples of accelerations were lost</source>
        <translation>часть отсчётов ускорений потеряна (переполнение буфера обмена)</translation>
    </message>
    <message>
        <source>packets of samples do not follow each other</source>
        <translation>пакеты отсчётов идут не подряд (ошибка синхронизации)</translation>
    </message>
    <message>
        <source>the sensor has restarted</source>
        <translation>датчик перезапускался</translation>
    </message>
    <message>
        <source>the thermostat has not settled</source>
        <translation>терморегулирование не завершено</translation>
    </message>
    <message>
        <source>the heater is at its minimum</source>
        <translation>минимальная мощность нагрева</translation>
    </message>
    <message>
        <source>the heater is at its maximum</source>
        <translation>максимальная мощность нагрева</translation>
    </message>
    <message>
        <source>Bits 15…12</source>
        <translation>Биты 15…12</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Описание</translation>
    </message>
    <message>
        <source>Two bits</source>
        <translation>Два бита</translation>
    </message>
    <message>
        <source>The port</source>
        <translation>Порт</translation>
    </message>
    <message>
        <source>has no errors, or there is none</source>
        <translation>без ошибок или отсутствует</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>не открывается</translation>
    </message>
    <message>
        <source>was lost, or takes no bytes</source>
        <translation>пропал или не принимает данные</translation>
    </message>
    <message>
        <source>is switched off</source>
        <translation>выключен</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Код</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Датчики</translation>
    </message>
    <message>
        <source>Words and codes</source>
        <translation>Слова и коды</translation>
    </message>
    <message>
        <source>Channel word: port i in bits 2(i−1) and 2(i−1)+1</source>
        <translation>Слово состояния канала: порт i в битах 2(i−1) и 2(i−1)+1</translation>
    </message>
    <message>
        <source>Unit 1: flags</source>
        <translation>Устройство 1: flags (флаги)</translation>
    </message>
    <message>
        <source>Unit 1: quantities</source>
        <translation>Устройство 1: quantities (величины)</translation>
    </message>
    <message>
        <source>Unit 1: type</source>
        <translation>Устройство 1: type (тип)</translation>
    </message>
    <message>
        <source>Modbus register map</source>
        <translation>Карта регистров Modbus</translation>
    </message>
    <message>
        <source>The server is switched off in this configuration (CanModbus=0).</source>
        <translation>В этой конфигурации сервер выключен (CanModbus=0).</translation>
    </message>
    <message>
        <source>Modbus TCP, port %1. Nothing can be written.</source>
        <translation>Modbus TCP, порт %1. Только чтение.</translation>
    </message>
    <message>
        <source>ModbusPacking=ByNumber: in every unit slot 0 is N=1, slot 1 is N=2 and so on. Slots without a sensor are not listed; they hold the status word 0F00h and nothing else.</source>
        <translation>ModbusPacking=ByNumber: в каждом устройстве место 0 – N=1, место 1 – N=2 и так далее. Места без датчика не перечислены; в них только слово состояния 0F00h.</translation>
    </message>
    <message>
        <source>ModbusPacking=ByType: the sensors of a unit follow each other in ascending N, switched-off ones included. Their places change only when sensors are added to the ini or taken out.</source>
        <translation>ModbusPacking=ByType: датчики устройства идут подряд по возрастанию N, включая выключенные. Их места меняются, только если датчики добавлены в ini или убраны из него.</translation>
    </message>
    <message>
        <source>A register is given as in the request, counted from 0, and as programs give it that count from 1 and put the kind of register in front: 30001 is register 0 read with function 04, 40001 the same with function 03. Behind 39999 there are five digits: 310000.</source>
        <translation>Регистр указан так, как он стоит в запросе (счёт от 0), и так, как его указывают программы, которые считают от 1 и ставят впереди вид регистра: 30001 – регистр 0, читаемый функцией 04, 40001 – он же, функция 03. После 39999 цифр пять: 310000.</translation>
    </message>
    <message>
        <source>A request reads any part of a unit, at most 125 registers. Exceptions: 0B no such unit, 01 function, 03 quantity, 02 registers that do not exist.</source>
        <translation>Одним запросом читается любая часть устройства, не более 125 регистров. Исключения: 0B – нет такого устройства, 01 – функция, 03 – количество, 02 – таких регистров нет.</translation>
    </message>
    <message>
        <source>Order of the bytes on the wire: A is the high byte of the value.</source>
        <translation>Порядок байтов при передаче: A – старший байт значения.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Датчик</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Порт</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Адрес</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Место установки</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Включён</translation>
    </message>
    <message>
        <source>From register, unit %1</source>
        <translation>С регистра, устройство %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>да</translation>
    </message>
    <message>
        <source>no</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Регистр</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Регистров</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Поле</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Порядок</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Множитель</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Ед. изм.</translation>
    </message>
    <message>
        <source>All numbers low byte first, in the registers too: where usual Modbus has 1234h, there is 3412h. Swap the bytes of every register, and the registers of the channel word.</source>
        <translation>Все числа передаются младшим байтом вперёд, в том числе внутри регистров: там, где в обычном Modbus 1234h, здесь 3412h. Поменяйте местами байты каждого регистра, а у слова состояния канала ещё и регистры.</translation>
    </message>
    <message>
        <source>All numbers high byte first, of several registers the high one first, as Modbus is usually read.</source>
        <translation>Все числа передаются старшим байтом вперёд, из нескольких регистров первым идёт старший, как принято в Modbus.</translation>
    </message>
    <message>
        <source>Unit %1. %2</source>
        <translation>Устройство %1. %2</translation>
    </message>
    <message>
        <source>Function %1; registers %2…%3.</source>
        <translation>Функция %1; регистры %2…%3.</translation>
    </message>
    <message>
        <source>03 or 04</source>
        <translation>03 или 04</translation>
    </message>
    <message>
        <source>Bytes of the answer</source>
        <translation>Байты ответа</translation>
    </message>
    <message>
        <source>What they are</source>
        <translation>Что это</translation>
    </message>
    <message>
        <source>transaction, as in the request</source>
        <translation>транзакция, как в запросе</translation>
    </message>
    <message>
        <source>protocol, as in the request</source>
        <translation>протокол, как в запросе</translation>
    </message>
    <message>
        <source>how many bytes follow</source>
        <translation>сколько байтов следует</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>устройство</translation>
    </message>
    <message>
        <source>function</source>
        <translation>функция</translation>
    </message>
    <message>
        <source>how many bytes of data follow</source>
        <translation>сколько байтов данных следует</translation>
    </message>
    <message>
        <source>Example: function 04, %1 registers from register %2, of sensor N=%3</source>
        <translation>Пример: функция 04, количество регистров %1, начиная с регистра %2, датчик N=%3</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Запрос</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Ответ</translation>
    </message>
    <message>
        <source>Angles of tilt</source>
        <translation>Углы наклона</translation>
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
        <source>Modbus &amp;register map…</source>
        <translation>Карта &amp;регистров Modbus…</translation>
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
    <message>
        <source>Prints the Modbus registers of the configuration as Markdown.</source>
        <translation>Печатает регистры Modbus этой конфигурации в формате Markdown.</translation>
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
        <translation>Описание</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Пояснение</translation>
    </message>
</context>
<context>
    <name>gorizont::RegisterMapDialog</name>
    <message>
        <source>Modbus register map</source>
        <translation>Карта регистров Modbus</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Копировать всё</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Сохранить как…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Save the register map</source>
        <translation>Сохранение карты регистров</translation>
    </message>
    <message>
        <source>Markdown (*.md)</source>
        <translation>Markdown (*.md)</translation>
    </message>
    <message>
        <source>The file cannot be saved.</source>
        <translation>Не удалось сохранить файл.</translation>
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
