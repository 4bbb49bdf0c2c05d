# fish completion for feltline-desktop
complete -c feltline-desktop -s h -l help -d 'Show help'
complete -c feltline-desktop -s v -l version -d 'Show the version'
complete -c feltline-desktop -l new-window -d 'Open a separate window with an empty drawing'
complete -c feltline-desktop -l language -x -a 'en de nl' -d 'Use this language instead of that of the system'
complete -c feltline-desktop -l record -r -d 'Record everything that happens to the drawing'
