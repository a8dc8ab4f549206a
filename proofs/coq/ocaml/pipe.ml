(* A program behind a pipe (docs/protocol.md) as what the theorem speaks of: a function of the percepts
   so far.

   What the program has said after each sequence of percepts is kept in a tree.  A sequence that is in
   the tree is never asked for again, so that the answers are those of a function.  When a longer one is
   asked for, the episode is played again from its start, and if the program then says something else
   than before it is no function: Not_a_function. *)
open Certified

type said =
  | Motion of int
  | Estimate of numbered_map
  | Fault of string * string  (* the law of docs/protocol.md that it breaks, and how *)

exception Not_a_function of { history : string list; before : said; now : said }

(* How percepts are handed over: one as JSON, what is told beside the first, the degree in it. *)
type 'o words = { show : 'o -> string; told : 'o -> string; degree : 'o -> int }

type 'o node = {
  history : 'o list;  (* the percepts so far, the last one first *)
  mutable said : said option;
  mutable after : ('o * 'o node) list }

type process = { pid : int; input : Unix.file_descr; output : Unix.file_descr; buffer : Buffer.t }

type 'o t = {
  command : string array;
  timeout : float;
  words : 'o words;
  mutable process : process option;
  mutable standing : 'o node option;  (* the node whose motion waits for its percept *)
  mutable first : ('o * 'o node) list;
  mutable episodes : int }

let longest_line = 1 lsl 24
let most_checkpoints = 1_000_000

let create words ~timeout command =
  ignore (Sys.signal Sys.sigpipe Sys.Signal_ignore);
  { command; timeout; words; process = None; standing = None; first = []; episodes = 0 }

let stop t =
  Stdlib.Option.iter (fun p ->
    List.iter (fun fd -> try Unix.close fd with Unix.Unix_error _ -> ()) [p.input; p.output];
    (try Unix.kill p.pid Sys.sigkill with Unix.Unix_error _ -> ());
    ignore (Unix.waitpid [] p.pid)) t.process;
  t.process <- None; t.standing <- None

let running t = match t.process with
  | Some p -> p
  | None ->
      let theirs, input = Unix.pipe ~cloexec:true () in
      let output, mine = Unix.pipe ~cloexec:true () in
      let pid = Unix.create_process t.command.(0) t.command theirs mine Unix.stderr in
      Unix.close theirs; Unix.close mine;
      let p = { pid; input; output; buffer = Buffer.create 256 } in
      t.process <- Some p; p

(* ---- Lines ---- *)
let send p line =
  let bytes = Bytes.of_string (line ^ "\n") in
  let rec from i =
    if i < Bytes.length bytes then from (i + Unix.write p.input bytes i (Bytes.length bytes - i)) in
  from 0

type line = Line of string | Ended | Silence

let receive t p =
  let deadline = Unix.gettimeofday () +. t.timeout in
  let chunk = Bytes.create 65536 in
  let rec go () =
    let text = Buffer.contents p.buffer in
    match String.index_opt text '\n' with
    | Some i ->
        Buffer.clear p.buffer;
        Buffer.add_substring p.buffer text (i + 1) (String.length text - i - 1);
        Line (String.sub text 0 i)
    | None when String.length text > longest_line -> Line ""
    | None ->
        let left = deadline -. Unix.gettimeofday () in
        match Unix.select [p.output] [] [] (Float.max left 0.) with
        | [], _, _ -> Silence
        | _ ->
            match Unix.read p.output chunk 0 (Bytes.length chunk) with
            | 0 -> Ended
            | n -> Buffer.add_subbytes p.buffer chunk 0 n; go () in
  go ()

(* ---- What a line says ---- *)
let sayings = ["move"; "drop"; "pick"; "checkpoint"; "estimate"]

let natural = function Json.Int n when n >= 0 -> n | _ -> raise (Json.Malformed "a dart expected")
let naturals = function Json.List l -> List.map natural l | _ -> raise (Json.Malformed "a list expected")

let estimate e =
  try
    Estimate { sigma_list = naturals (Json.field "sigma" e);
               alpha_list = naturals (Json.field "alpha" e);
               root_number = natural (Json.field "here" e) }
  with Json.Malformed why -> Fault ("no-estimate", why)

(* None: a checkpoint, which has no answer *)
let meaning degree line =
  let illegal = Some (Fault ("illegal-action", String.sub line 0 (min 80 (String.length line)))) in
  match Json.parse line with
  | exception (Json.Malformed _ | Failure _) -> illegal
  | Json.Object items ->
      (match List.filter (fun (key, _) -> List.mem key sayings) items with
       | ["move", Json.Int k] -> Some (Motion (((k mod degree) + degree) mod degree))
       | ["estimate", e] -> Some (estimate e)
       | ["checkpoint", _] -> None
       | _ -> illegal)
  | _ -> illegal

let rec hear t p degree checkpoints =
  match receive t p with
  | Ended -> Fault ("crash", "the output has ended")
  | Silence -> Fault ("timeout", Printf.sprintf "no line in %g s" t.timeout)
  | Line line ->
      match meaning degree line with
      | Some said -> said
      | None when checkpoints = most_checkpoints -> Fault ("budget", "checkpoints without end")
      | None -> hear t p degree (checkpoints + 1)

(* ---- Asking ---- *)
let say t node line =
  let p = running t in
  let degree = t.words.degree (List.hd node.history) in
  let said =
    try send p line; hear t p degree 0
    with Unix.Unix_error (EPIPE, _, _) -> Fault ("crash", "the input is closed") in
  (match node.said with
   | Some before when before <> said ->
       raise (Not_a_function
         { history = List.rev_map t.words.show node.history; before; now = said })
   | _ -> node.said <- Some said);
  (match said with
   | Motion _ -> t.standing <- Some node
   | Estimate _ -> t.standing <- None
   | Fault _ -> stop t)

let begin_episode t node o =
  if t.standing <> None then stop t;
  t.episodes <- t.episodes + 1;
  say t node (Printf.sprintf "{\"episode\":%d,\"percept\":%s%s}" t.episodes (t.words.show o) (t.words.told o))

let child of_ o = List.assoc o of_

(* the program is led to the node, from where it stands or from the start *)
let lead t node =
  match node.history with
  | [] -> invalid_arg "Pipe.lead"
  | o :: earlier ->
      let goes_on = match t.standing with Some n -> n.history == earlier | None -> false in
      if goes_on then say t node (Printf.sprintf "{\"percept\":%s}" (t.words.show o))
      else
        let rec along at = function
          | [] -> ()
          | o :: rest ->
              let next = child at.after o in
              say t next (Printf.sprintf "{\"percept\":%s}" (t.words.show o));
              along next rest in
        match List.rev node.history with
        | [] -> ()
        | first :: rest ->
            let root = child t.first first in
            begin_episode t root first;
            along root rest

let no_map = { sigma_list = []; alpha_list = []; root_number = 0 }

let rec decide t node = match node.said with
  | Some (Motion k) -> Move k
  | Some (Estimate e) -> Stop e
  | Some (Fault _) -> Stop no_map
  | None -> lead t node; decide t node

let fresh history = { history; said = None; after = [] }

let resumption t = {
  begins = (fun o ->
    match List.assoc_opt o t.first with
    | Some node -> node
    | None -> let node = fresh [o] in t.first <- (o, node) :: t.first; node);
  decides = decide t;
  goes_on = (fun node o ->
    match List.assoc_opt o node.after with
    | Some next -> next
    | None -> let next = fresh (o :: node.history) in node.after <- (o, next) :: node.after; next) }

(* the fault with which a run through these percepts has ended, if it has *)
let fault t percepts =
  let rec along node = function
    | [] -> (match node.said with Some (Fault (law, how)) -> Some (law, how) | _ -> None)
    | o :: rest -> (match List.assoc_opt o node.after with Some next -> along next rest | None -> None) in
  match percepts with
  | [] -> None
  | o :: rest -> Stdlib.Option.bind (List.assoc_opt o t.first) (fun root -> along root rest)
