(* A program behind a pipe (docs/protocol.md) as what the theorem speaks of: a function of the percepts
   so far.

   What the program has said after each sequence of percepts is kept in a tree.  A sequence that is in
   the tree is never asked for again, so that the answers are those of a function.  When a longer one is
   asked for, the episode is played again from its start, and if the program then says something else
   than before it is no function: Not_a_function.

   Its lines are read as Json.parse reads: strictly.  A line that is no JSON, or says none of what an
   explorer may say, is a fault, with its reason; so is an answer with more darts than any world has
   that is asked about, which is not looked at further: it is wrong. *)
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
  most_darts : int;  (* of any world that is asked about *)
  most_checkpoints : int;  (* before a motion, or the answer *)
  words : 'o words;
  mutable process : process option;
  mutable standing : 'o node option;  (* the node whose motion waits for its percept *)
  mutable first : ('o * 'o node) list;
  mutable episodes : int }

let longest_line = 1 lsl 24

let create words ~timeout ~most_darts ~most_checkpoints command =
  ignore (Sys.signal Sys.sigpipe Sys.Signal_ignore);
  { command; timeout; most_darts; most_checkpoints; words; process = None; standing = None; first = []; episodes = 0 }

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

type line = Line of string | Ended | Silence | Too_long

(* one read, within so many seconds: how many bytes, 0 at the end; None: none came *)
let read_within p chunk seconds =
  match Unix.select [p.output] [] [] (Float.max seconds 0.) with
  | [], _, _ -> None
  | _ -> Some (Unix.read p.output chunk 0 (Bytes.length chunk))

let receive t p =
  let deadline = Unix.gettimeofday () +. t.timeout in
  let chunk = Bytes.create 65536 in
  let rec go searched =
    let length = Buffer.length p.buffer in
    let rec line_end i =
      if i = length then None else if Buffer.nth p.buffer i = '\n' then Some i else line_end (i + 1) in
    match line_end searched with
    | Some i ->
        let line = Buffer.sub p.buffer 0 i and rest = Buffer.sub p.buffer (i + 1) (length - i - 1) in
        Buffer.clear p.buffer;
        Buffer.add_string p.buffer rest;
        Line line
    | None when length > longest_line -> Too_long
    | None ->
        match read_within p chunk (deadline -. Unix.gettimeofday ()) with
        | None -> Silence
        | Some 0 -> Ended
        | Some n -> Buffer.add_subbytes p.buffer chunk 0 n; go length in
  go 0

(* ---- What a line says ---- *)
let sayings = ["move"; "drop"; "pick"; "checkpoint"; "estimate"; "ambiguous"]

let beginning line = String.sub line 0 (min 80 (String.length line))
let illegal why line = Fault ("illegal-action", Printf.sprintf "%s: %s" why (beginning line))

let natural = function Json.Int n when n >= 0 -> n | _ -> Json.malformed "a dart expected"

let estimate most_darts e =
  let naturals key = match Json.field key e with
    | Json.List _ as l -> Json.list natural l
    | _ -> Json.malformed (Printf.sprintf "%s: a list expected" key) in
  match { sigma_list = naturals "sigma"; alpha_list = naturals "alpha";
          root_number = natural (Json.field "here" e) } with
  | exception Json.Malformed why -> Fault ("no-estimate", why)
  | answer ->
      let darts = max (List.length answer.sigma_list) (List.length answer.alpha_list) in
      if darts <= most_darts then Estimate answer
      else Fault ("map", Printf.sprintf "an answer with %d darts; no world here has more than %d" darts most_darts)

let whole = function
  | Json.Object items -> List.for_all (fun key -> List.mem_assoc key items) ["sigma"; "alpha"; "here"]
  | _ -> false

(* None: a checkpoint, which has no answer *)
let meaning most_darts degree line =
  match Json.parse line with
  | exception Json.Malformed why -> Some (illegal why line)
  | Json.Object items ->
      (match List.filter (fun (key, _) -> List.mem key sayings) items with
       | ["move", k] ->
           (match Json.modulo degree k with
            | Some k -> Some (Motion k)
            | None -> Some (illegal "a motion that is no integer" line))
       | ["estimate", e] -> Some (estimate most_darts e)
       | ["ambiguous", _] -> Some (Fault ("no-estimate", "ambiguous"))
       | ["checkpoint", c] -> if whole c then None else Some (illegal "no checkpoint" line)
       | [name, _] -> Some (illegal (name ^ " is not for this lighthouse") line)
       | [] -> Some (illegal "no action, checkpoint or estimate" line)
       | _ -> Some (illegal "more than one action, checkpoint or estimate" line))
  | _ -> Some (illegal "no object" line)

let rec hear t p degree checkpoints =
  match receive t p with
  | Ended -> Fault ("crash", "the output has ended")
  | Silence -> Fault ("timeout", Printf.sprintf "no line in %g s" t.timeout)
  | Too_long -> Fault ("illegal-action", Printf.sprintf "a line of more than %d bytes" longest_line)
  | Line line ->
      match meaning t.most_darts degree line with
      | Some (Estimate _) when Buffer.length p.buffer > 0 ->
          illegal "a line after the answer" (Buffer.contents p.buffer)
      | Some said -> said
      | None when checkpoints = t.most_checkpoints ->
          Fault ("budget", Printf.sprintf "more than %d checkpoints before a motion" checkpoints)
      | None -> hear t p degree (checkpoints + 1)

(* ---- Asking ---- *)
(* what it has said at a node; before, if it has been there, it must have said that *)
let record t node said =
  (match node.said with
   | Some before when before <> said ->
       raise (Not_a_function
         { history = List.rev_map t.words.show node.history; before; now = said })
   | _ -> node.said <- Some said);
  match said with
  | Motion _ -> t.standing <- Some node
  | Estimate _ -> t.standing <- None
  | Fault _ -> stop t

let say t node line =
  let p = running t in
  let degree = t.words.degree (List.hd node.history) in
  record t node
    (try send p line; hear t p degree 0
     with Unix.Unix_error (EPIPE, _, _) -> Fault ("crash", "the input is closed"))

(* what was written before it was asked for; a process that has ended is noticed by the next line *)
let written_ahead t =
  match t.process with
  | None -> ""
  | Some p ->
      let chunk = Bytes.create 65536 in
      (match read_within p chunk 0. with Some n -> Buffer.add_subbytes p.buffer chunk 0 n | None -> ());
      Buffer.contents p.buffer

let begin_episode t node o =
  if t.standing <> None then stop t;
  t.episodes <- t.episodes + 1;
  match written_ahead t with
  | "" ->
      say t node
        (Printf.sprintf "{\"episode\":%d,\"percept\":%s%s}" t.episodes (t.words.show o) (t.words.told o))
  | text -> record t node (illegal "a line before it was asked" text)

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
