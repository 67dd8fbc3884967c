autocmd BufRead,BufNewFile *.scene setfiletype raylab
