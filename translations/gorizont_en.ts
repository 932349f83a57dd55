<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AlarmText</name>
    <message numerus="yes">
        <source>%n sensor(s) need attention</source>
        <translation>
            <numerusform>%n sensor needs attention</numerusform>
            <numerusform>%n sensors need attention</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::AlarmWatch</name>
    <message numerus="yes">
        <source>Accepted by the dispatcher: %n message(s)</source>
        <translation>
            <numerusform>Accepted by the dispatcher: %n message</numerusform>
            <numerusform>Accepted by the dispatcher: %n messages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::ClientsPage</name>
    <message numerus="yes">
        <source>Disconnect %n client(s)?</source>
        <translation>
            <numerusform>Disconnect %n client?</numerusform>
            <numerusform>Disconnect %n clients?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::ComplaintsDialog</name>
    <message numerus="yes">
        <source>%n entry(ies) of the configuration file cannot be used as they are. The program works without them.</source>
        <translation>
            <numerusform>%n entry of the configuration file cannot be used as it is. The program works without it.</numerusform>
            <numerusform>%n entries of the configuration file cannot be used as they are. The program works without them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::DayCalendar</name>
    <message numerus="yes">
        <source>and %n more sensor(s)</source>
        <translation>
            <numerusform>and %n more sensor</numerusform>
            <numerusform>and %n more sensors</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::Mk14Dialog</name>
    <message numerus="yes">
        <source>Send %1 (%n byte(s)) to station %2? It replaces the station&apos;s own file of this name. A wrong file may stop its measurements.</source>
        <translation>
            <numerusform>Send %1 (%n byte) to station %2? It replaces the station&apos;s own file of this name. A wrong file may stop its measurements.</numerusform>
            <numerusform>Send %1 (%n bytes) to station %2? It replaces the station&apos;s own file of this name. A wrong file may stop its measurements.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>file %1, %n byte(s)</source>
        <translation>
            <numerusform>file %1, %n byte</numerusform>
            <numerusform>file %1, %n bytes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::Mk14TransferPanel</name>
    <message numerus="yes">
        <source>%1, %n byte(s)</source>
        <translation>
            <numerusform>%1, %n byte</numerusform>
            <numerusform>%1, %n bytes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::RecordedSource</name>
    <message numerus="yes">
        <source>%n value(s) are expected</source>
        <translation>
            <numerusform>%n value is expected</numerusform>
            <numerusform>%n values are expected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::SourceFile</name>
    <message numerus="yes">
        <source>%n number(s) are expected here.</source>
        <translation>
            <numerusform>%n number is expected here.</numerusform>
            <numerusform>%n numbers are expected here.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::UsmDialog</name>
    <message numerus="yes">
        <source>%n new record(s)</source>
        <translation>
            <numerusform>%n new record</numerusform>
            <numerusform>%n new records</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s) saved</source>
        <translation>
            <numerusform>%n record saved</numerusform>
            <numerusform>%n records saved</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::tool::Text</name>
    <message numerus="yes">
        <source>address %1, %n sensor(s) found</source>
        <translation>
            <numerusform>address %1, %n sensor found</numerusform>
            <numerusform>address %1, %n sensors found</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s) found</source>
        <translation>
            <numerusform>%n sensor found</numerusform>
            <numerusform>%n sensors found</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n address(es) asked</source>
        <translation>
            <numerusform>%n address asked</numerusform>
            <numerusform>%n addresses asked</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s)</source>
        <translation>
            <numerusform>%n record</numerusform>
            <numerusform>%n records</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n measurement(s) missing</source>
        <translation>
            <numerusform>%n measurement missing</numerusform>
            <numerusform>%n measurements missing</numerusform>
        </translation>
    </message>
</context>
</TS>
