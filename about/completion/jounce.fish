# Completion of jounce in fish. The program itself finds the words: jounce __complete WORD...
function __jounce_complete
    set -l line (commandline -opc)
    set -l word (commandline -ct)
    for found in ($line[1] __complete $line[2..] "$word" 2> /dev/null)
        if test "$found" = :files
            set -l option (string match -r -- '^--[^=]*=' $word)
            for path in (__fish_complete_path (string replace -r -- '^--[^=]*=' '' "$word"))
                echo -- "$option$path"
            end
        else
            echo -- $found
        end
    end
end
complete -c jounce -f -a '(__jounce_complete)'
