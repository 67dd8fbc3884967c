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

(* {1 Ctrl-C where nobody types}

   What is under way ends as by any exception, and cleans up. Then the program
   dies of the signal, as a loop of the shell that runs it expects. *)

let note_ctrl_c interrupted =
  let handle _ =
    interrupted := true;
    raise Sys.Break
  in
  match Sys.signal Sys.sigint (Signal_handle handle) with
  | Signal_ignore -> Sys.set_signal Sys.sigint Signal_ignore
  | _ -> ()

let die_if interrupted =
  if !interrupted then (
    Sys.set_signal Sys.sigint Signal_default;
    Unix.kill (Unix.getpid ()) Sys.sigint)

let script path =
  Sys.interactive := false;
  Toploop.override_sys_argv [| path |];
  let interrupted = ref false in
  note_ctrl_c interrupted;
  let ended_well = Toploop.use_silently Format.err_formatter (File path) in
  die_if interrupted;
  if ended_well then 0 else 2

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

(* {1 Without a line editor} *)

(* with which the toplevel asks for a phrase, not for a further line of it *)
let first_prompt = "# "

(* [reader ~ask] gives the toplevel a line at a time, which it may [ask] for,
   the first without a mark, and at the end of the input, which ends a phrase
   that was begun, one more. *)
let reader ~ask =
  let rest = ref "" in
  let started = ref false in
  let read_line prompt =
    match In_channel.input_line stdin with
    | Some line when not !started ->
        started := true;
        Mark.without line ^ "\n"
    | Some line -> line ^ "\n"
    | None when prompt = first_prompt -> exit 0
    | None -> ";;\n"
  in
  fun prompt buffer length ->
    if !rest = "" then (
      ask prompt;
      rest := read_line prompt);
    let count = Int.min length (String.length !rest) in
    Bytes.blit_string !rest 0 buffer 0 count;
    rest := String.sub !rest count (String.length !rest - count);
    (count, false)

let loop ~ask =
  Clflags.noversion := true;
  Clflags.noinit := true;
  Toploop.read_interactive_input := reader ~ask;
  match Toploop.loop Format.std_formatter with
  | () -> exit 0
  | exception Compenv.Exit_with_status status -> exit status

let standard_input () =
  let interrupted = ref false in
  loop ~ask:(fun _ ->
      die_if interrupted;
      (* the loop began with a handler of its own *)
      note_ctrl_c interrupted)

let plain_terminal ~greeting =
  greeting ();
  at_exit print_newline;
  loop ~ask:(fun prompt ->
      print_string (if prompt = first_prompt then "raylab # " else prompt);
      flush stdout)
