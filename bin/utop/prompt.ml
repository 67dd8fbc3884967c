(* Every value of Printers is a printer. utop would find them by their
   attributes, but only at a terminal. *)
let install_printers () =
  let name = [ "Raylab_toplevel"; "Printers" ] in
  let longident path = Option.get (Longident.unflatten path) in
  let _, printers =
    Env.find_module_by_name (longident name) !Toploop.toplevel_env
  in
  let install = function
    | Types.Sig_value (id, _, _) ->
        Topdirs.dir_install_printer Format.err_formatter
          (longident (name @ [ Ident.name id ]))
    | _ -> ()
  in
  match Env.scrape_alias !Toploop.toplevel_env printers.md_type with
  | Mty_signature values -> List.iter install values
  | _ -> ()

(* The compiler prints the first answer before it knows the shortest names of
   all types. So nobody sees the first answer. *)
let warm_up () =
  let nowhere = Format.make_formatter (fun _ _ _ -> ()) ignore in
  ignore (Toploop.use_input nowhere (String "()") : bool)

(* In scripts, and in the files of #use. *)
let skip_marks () =
  let parse = !Toploop.parse_use_file in
  Toploop.parse_use_file :=
    fun lexbuf ->
      Mark.skip lexbuf;
      parse lexbuf

let prepare () =
  Format.set_margin 80;
  Compmisc.init_path ();
  Toploop.initialize_toplevel_env ();
  install_printers ();
  skip_marks ();
  warm_up ()

let script path =
  Sys.interactive := false;
  Toploop.override_sys_argv [| path |];
  if Toploop.use_silently Format.err_formatter (File path) then 0 else 2

(* {1 utop} *)

let prompt =
  LTerm_text.eval
    [ B_bold true; B_fg LTerm_style.lcyan; S "raylab"; E_fg; S " # "; E_bold ]

let terminal ~greeting =
  UTop.prompt := React.S.const prompt;
  UTop.history_file_name := History.file ();
  let begin_ =
    lazy
      ((* utop raises when its terminal goes away, and may catch that itself *)
       Sys.set_signal Sys.sighup Signal_default;
       greeting ())
  in
  UTop.at_new_command (fun () -> Lazy.force begin_);
  (* utop has options of its own, which are not ours *)
  Toploop.override_sys_argv [| Sys.executable_name |];
  UTop_main.main ()

(* {1 No terminal} *)

(* [reader ()] gives the toplevel a line at a time, the first without a mark, and
   at the end of the input, which ends the last phrase, one more. *)
let reader () =
  let rest = ref "" in
  let started = ref false in
  let ended = ref false in
  let read_line () =
    match In_channel.input_line stdin with
    | Some line when not !started ->
        started := true;
        Mark.without line ^ "\n"
    | Some line -> line ^ "\n"
    | None when !ended -> exit 0
    | None ->
        ended := true;
        ";;\n"
  in
  fun _prompt buffer length ->
    if !rest = "" then rest := read_line ();
    let count = Int.min length (String.length !rest) in
    Bytes.blit_string !rest 0 buffer 0 count;
    rest := String.sub !rest count (String.length !rest - count);
    (count, false)

let standard_input () =
  Clflags.noversion := true;
  Clflags.noinit := true;
  Toploop.read_interactive_input := reader ();
  match Toploop.loop Format.std_formatter with
  | () -> exit 0
  | exception Compenv.Exit_with_status status -> exit status
