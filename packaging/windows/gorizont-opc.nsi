; Installer of the OPC DA part: gateway, proxy, registration. Compiled by packaging/windows/build, which gives VERSION (of the
; program), PROGRAMS (folder with the gateway and its proxy), README and OUTPUT (file to write).

Unicode true
Target amd64-unicode
SetCompressor /SOLID lzma

!include LogicLib.nsh
!include x64.nsh

!define GATEWAY "gorizont-opc-da.exe"
!define PROXY "gorizont-opc-proxy.dll"
!define PROXY32 "gorizont-opc-proxy32.dll"
!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\GorizontServerOpc"

LoadLanguageFile "${NSISDIR}/Contrib/Language files/Russian.nlf"
LoadLanguageFile "${NSISDIR}/Contrib/Language files/English.nlf"

LangString NeedsWindows64 ${LANG_RUSSIAN} "Нужна 64-разрядная Windows."
LangString NeedsWindows64 ${LANG_ENGLISH} "A 64-bit Windows is needed."
LangString InUse ${LANG_RUSSIAN} "Шлюз OPC DA работает. Завершите клиентов OPC и повторите."
LangString InUse ${LANG_ENGLISH} "The OPC DA gateway is running. End the OPC clients and try again."
LangString NotRegistered ${LANG_RUSSIAN} "Сервер OPC.DA.GorizontServer не удалось зарегистрировать (ошибка $0). Запустите установку от имени администратора."
LangString NotRegistered ${LANG_ENGLISH} "The server OPC.DA.GorizontServer could not be registered (error $0). Run the installer as administrator."
LangString NotUnregistered ${LANG_RUSSIAN} "Записи в реестре не удалось убрать (ошибка $0). Запустите удаление от имени администратора."
LangString NotUnregistered ${LANG_ENGLISH} "The entries in the registry could not be removed (error $0). Run the uninstaller as administrator."

Name "Gorizont Server OPC DA"
OutFile "${OUTPUT}"
InstallDir "$PROGRAMFILES64\Gorizont Server"
InstallDirRegKey HKLM "${UNINSTALL}" "InstallLocation"
RequestExecutionLevel admin
ShowInstDetails show
VIProductVersion "${VERSION}.0"
VIFileVersion "${VERSION}.0"
VIAddVersionKey /LANG=${LANG_ENGLISH} "ProductName" "Gorizont Server OPC DA"
VIAddVersionKey /LANG=${LANG_ENGLISH} "ProductVersion" "${VERSION}"
VIAddVersionKey /LANG=${LANG_ENGLISH} "FileVersion" "${VERSION}"
VIAddVersionKey /LANG=${LANG_ENGLISH} "FileDescription" "Gorizont Server OPC DA"
VIAddVersionKey /LANG=${LANG_ENGLISH} "LegalCopyright" "GPL"

Page directory
Page instfiles
UninstPage uninstConfirm
UninstPage instfiles

; Ends with an error that a silent run shows by its exit code.
!macro Give_Up TEXT
    MessageBox MB_OK|MB_ICONSTOP "${TEXT}" /SD IDOK
    SetErrorLevel 2
    Abort "${TEXT}"
!macroend

Function .onInit
    ${IfNot} ${RunningX64}
        !insertmacro Give_Up "$(NeedsWindows64)"
    ${EndIf}
    SetRegView 64
    SetShellVarContext all
FunctionEnd

Function un.onInit
    SetRegView 64
    SetShellVarContext all
FunctionEnd

Section
    ; A gateway that runs cannot be replaced, and one half of a pair must not be: look before anything is written.
    ${If} ${FileExists} "$INSTDIR\${GATEWAY}"
        ClearErrors
        FileOpen $1 "$INSTDIR\${GATEWAY}" a
        ${If} ${Errors}
            !insertmacro Give_Up "$(InUse)"
        ${EndIf}
        FileClose $1
    ${EndIf}
    SetOutPath "$INSTDIR"
    File "${PROGRAMS}/${GATEWAY}"
    File "${PROGRAMS}/${PROXY}"
!if /FileExists "${PROGRAMS}/${PROXY32}"
    File "${PROGRAMS}/${PROXY32}"
!endif
    File "/oname=OPC DA.txt" "${README}"
    WriteUninstaller "$INSTDIR\uninstall-opc.exe"

    ; Interfaces that have a proxy already, such as that of the OPC Core Components, keep it: the gateway looks.
    ExecWait '"$INSTDIR\${GATEWAY}" /RegServer' $0
    ${If} $0 <> 0
        !insertmacro Give_Up "$(NotRegistered)"
    ${EndIf}

    WriteRegStr HKLM "${UNINSTALL}" "DisplayName" "Gorizont Server OPC DA"
    WriteRegStr HKLM "${UNINSTALL}" "DisplayVersion" "${VERSION}"
    WriteRegStr HKLM "${UNINSTALL}" "InstallLocation" "$INSTDIR"
    WriteRegStr HKLM "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall-opc.exe"'
    WriteRegStr HKLM "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall-opc.exe" /S'
    WriteRegDWORD HKLM "${UNINSTALL}" "NoModify" 1
    WriteRegDWORD HKLM "${UNINSTALL}" "NoRepair" 1
SectionEnd

Section Uninstall
    ExecWait '"$INSTDIR\${GATEWAY}" /UnregServer' $0
    ${If} $0 <> 0
        !insertmacro Give_Up "$(NotUnregistered)"
    ${EndIf}
    ; What a client holds open goes with the next start of Windows.
    Delete /REBOOTOK "$INSTDIR\${GATEWAY}"
    Delete /REBOOTOK "$INSTDIR\${PROXY}"
    Delete /REBOOTOK "$INSTDIR\${PROXY32}"
    Delete "$INSTDIR\OPC DA.txt"
    Delete /REBOOTOK "$INSTDIR\uninstall-opc.exe"
    RMDir "$INSTDIR" ; only when nothing of the main program is there
    DeleteRegKey HKLM "${UNINSTALL}"
SectionEnd
