(* ---------------------------------------------------------------------------------------------
   Robots that carry markers: they put them down where they are, and pick them up.  Sections IV and VIII

   At first all markers are in the robot's hand.  It senses the degree, and how many lie at its vertex.

     state                the robot's dart; of each marker that lies, a dart of its vertex.
     operation            Leave k, a motion; PutDown; PickUp.
     result hand a s      the state after a, where the robot has `hand` markers.  None: it has none left to
                          put down, or none lies here to be picked up.
     view_of s            what is sensed in s.
     carry                a robot in a world: the transcript (operations, each with what was sensed after
                          it), the answer, the last state.  No answer: an operation had no result, or the
                          budget, of operations, was not enough.
     carrying_explorer    any function from the views so far (the first one first) to an operation or to
                          an answer; carrying_episode: such an explorer, carried out.
     one_vertex_alike     in all worlds with one vertex, of one degree, it does and senses the same.

     plan A               a program of operations, with a result in A; after p f: p, then f of its result.
     as_plan p            a program that only moves.
     gives p s x s' t     run in state s, plan p gives x, in state s', and t is the transcript.
     does p s x s' n      the same, within n operations.
     repeated             the explorer that begins with a plan, then makes passes while a dart is open.
     episode_perform      it needs to remember its plan only.
     perform_as_plan      passes of Algorithm 1 are made as the machine of Algorithm.v makes them.
     repeated_ends        if each pass keeps an invariant, costs at most c, and explores an edge, it stops
                          within c operations for each edge, and the invariant holds.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Explorers PartialMaps Algorithm.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition view := (nat * nat)%type.
Inductive operation := Leave (k : nat) | PutDown | PickUp.
Definition carrying_explorer E := seq view -> operation + E.

Inductive plan A := Done (x : A) | Do (a : operation) (f : view -> plan A).

Fixpoint after A B (p : plan A) (f : A -> plan B) : plan B :=
  match p with
  | Done x => f x
  | Do a g => Do a (fun o => after (g o) f)
  end.

Fixpoint as_plan A (p : program view A) : plan A :=
  match p with
  | Return x => Done x
  | Go k f => Do (Leave k) (fun o => as_plan (f o))
  end.

(* ---- In a world ---- *)
Section World.
Variables (G : combinatorial_map) (hand : nat).
Definition state := (G * seq G)%type.
Implicit Types (s : state) (a : operation).

Definition lies_here s x := at_same_vertex x s.1.
Definition view_of s : view := (degree s.1, count (lies_here s) s.2).
Definition result a s : option state :=
  match a with
  | Leave k => Some (motion k s.1, s.2)
  | PutDown => if size s.2 < hand then Some (s.1, s.1 :: s.2) else None
  | PickUp =>
      let i := find (lies_here s) s.2 in
      if i < size s.2 then Some (s.1, take i s.2 ++ drop i.+1 s.2) else None
  end.

(* next: of what is remembered, what is done next, and what is remembered of what is seen then *)
Fixpoint carry T E (next : T -> operation * (view -> T) + E) budget t s :
    seq (operation * view) * option E * state :=
  match next t with
  | inr answer => ([::], Some answer, s)
  | inl (a, f) =>
      match budget, result a s with
      | budget'.+1, Some s' =>
          let: (transcript, answer, z) := carry next budget' (f (view_of s')) s' in
          ((a, view_of s') :: transcript, answer, z)
      | _, _ => ([::], None, s)
      end
  end.
Definition by_views E (X : carrying_explorer E) seen :=
  match X seen with inl a => inl (a, rcons seen) | inr answer => inr answer end.
Definition carrying_episode E (X : carrying_explorer E) d budget :=
  carry (by_views X) budget [:: view_of (d, [::])] (d, [::]).

Inductive gives A : plan A -> state -> A -> state -> seq (operation * view) -> Prop :=
| GivesDone x s : gives (Done x) s x s [::]
| GivesDo a f s s1 x s' t : result a s = Some s1 -> gives (f (view_of s1)) s1 x s' t ->
    gives (Do a f) s x s' ((a, view_of s1) :: t).
Definition does A (p : plan A) s x s' n := exists2 t, gives p s x s' t & size t <= n.

Lemma gives_after A B (p : plan A) (f : A -> plan B) s x s1 t y s' t' :
  gives p s x s1 t -> gives (f x) s1 y s' t' -> gives (after p f) s y s' (t ++ t').
Proof.
move=> M; elim: M f => //= a g {}s s2 {}x {}s1 {}t R _ IH f /IH; exact: GivesDo R.
Qed.

Lemma does_done A (x : A) s n : does (Done x) s x s n.
Proof. by exists [::] => //; exact: GivesDone. Qed.

Lemma does_do A a (f : view -> plan A) s s1 x s' n : result a s = Some s1 ->
  does (f (view_of s1)) s1 x s' n -> does (Do a f) s x s' n.+1.
Proof. by move=> R [t M le]; exists ((a, view_of s1) :: t) => //; exact: GivesDo R M. Qed.

Lemma does_after A B (p : plan A) (f : A -> plan B) s x s1 n y s' n' :
  does p s x s1 n -> does (f x) s1 y s' n' -> does (after p f) s y s' (n + n').
Proof.
case=> t M le [t' M' le']; exists (t ++ t'); first exact: gives_after M M'.
by rewrite size_cat leq_add.
Qed.

Lemma does_more A (p : plan A) s x s' n n' : n <= n' -> does p s x s' n -> does p s x s' n'.
Proof. by move=> le [t M /leq_trans/(_ le)]; exists t. Qed.
End World.

(* ---- Where there is one vertex all markers lie there ---- *)
Theorem one_vertex_alike (G H : combinatorial_map) (d : G) (e : H) hand E (X : carrying_explorer E) budget :
  (forall x y : G, at_same_vertex x y) -> (forall x y : H, at_same_vertex x y) -> degree d = degree e ->
  (carrying_episode hand X d budget).1 = (carrying_episode hand X e budget).1.
Proof.
move=> oG oH D; rewrite /carrying_episode.
have V (x : G) (y : H) a b : size a = size b -> view_of (x, a) = view_of (y, b).
  move=> E0; rewrite /view_of (degree_same (oG d x)) (degree_same (oH e y)) D.
  by rewrite !(eq_count (a2 := predT)) ?count_predT ?E0 // => z; rewrite /lies_here ?oG ?oH.
suff A seen (x : G) (y : H) a b : size a = size b -> (carry hand (by_views X) budget seen (x, a)).1
    = (carry hand (by_views X) budget seen (y, b)).1 by rewrite (V d e [::] [::]) //; exact: A.
elim: budget seen x y a b => [|n IH] seen x y a b E0 /=; case: (by_views X seen) => [[o f]|] //.
have: match result hand o (x, a), result hand o (y, b) with
      | Some s, Some s' => size s.2 = size s'.2 | None, None => True | _, _ => False end.
  case: o => [k| |] //=; first by rewrite E0; case: ifP => //= _; rewrite E0.
  by case: a b E0 => [|x1 a] [|y1 b] //= [E0]; rewrite /lies_here oG oH /= !drop0.
case: (result _ _ _) => [[x' a']|]; case: (result _ _ _) => [[y' b']|] //= E1.
rewrite (V x' y' a' b') //; have := IH (f (view_of (y', b'))) x' y' a' b' E1.
by do 2 case: (carry _ _ _ _ _) => [[? ?] ?] /=; case=> -> ->.
Qed.

(* ---- Pass after pass ---- *)
Section Repeated.
Variables (begun : view -> plan knowledge) (pass : knowledge -> plan knowledge).

Definition proceed (p : plan knowledge) : operation * (view -> plan knowledge) + numbered_map :=
  match p with
  | Do a f => inl (a, f)
  | Done k =>
      if unexplored k is _ :: _ then
        match pass k with Do a f => inl (a, f) | Done k' => inr (estimate k') end
      else inr (estimate k)
  end.
Definition told p o := if proceed p is inl (_, f) then f o else p.
Definition repeated : carrying_explorer numbered_map := fun seen =>
  match proceed (foldl told (begun (head (0, 0) seen)) (behead seen)) with
  | inl (a, _) => inl a
  | inr e => inr e
  end.

Variables (G : combinatorial_map) (hand : nat).
Implicit Types s : state G.
Local Notation perform := (@carry G hand _ _ proceed).

Theorem episode_perform d budget :
  carrying_episode hand repeated d budget = perform budget (begun (degree d, 0)) (d, [::]).
Proof.
rewrite /carrying_episode; set o := view_of _; rewrite -[(degree d, 0)]/o.
suff H seen s : carry hand (by_views repeated) budget (o :: seen) s
    = perform budget (foldl told (begun o) seen) s by exact: H.
elim: budget seen s => [|n IH] seen s /=; rewrite /by_views /repeated /=;
  case N: (proceed (foldl _ _ _)) => [[a f]|e] //.
by case: (result _ a s) => [s'|] //; rewrite (IH (rcons _ _)) -cats1 foldl_cat /= /told N.
Qed.

Lemma perform_gives p s x s' t budget : gives hand p s x s' t ->
  perform (size t + budget) p s
  = let: (t', e, z) := perform budget (Done x) s' in (t ++ t', e, z).
Proof.
elim=> [{}x {}s|a f {}s s1 {}x {}s' {}t R _ IH]; first by case: (perform _ _ _) => [[? ?] ?].
by rewrite [size _]/= addSn [LHS]/= R IH; case: (perform _ _ _) => [[? ?] ?].
Qed.

Variables (ready : knowledge -> state G -> Prop) (cost : nat).
Definition unexplored_edges k := edges G - (size (links (known_map k)))./2.
Hypothesis pass_acts : forall k, exists a f, pass k = Do a f.
Hypothesis pass_does : forall k s, ready k s -> unexplored k != [::] -> exists k' s',
  [/\ does hand (pass k) s k' s' cost, ready k' s' & unexplored_edges k' < unexplored_edges k].

Theorem repeated_ends k s : ready k s -> exists t k' s',
  [/\ forall budget, perform (size t + budget) (Done k) s = (t, Some (estimate k'), s'),
      size t <= unexplored_edges k * cost, ready k' s' & unexplored k' = [::]].
Proof.
have [N] := ubnP (unexplored_edges k); elim: N k s => // N IH k s lN R.
case U: (unexplored k) => [|e q].
  by exists [::], k, s; split=> // budget; case: (_ + _) => [|n] /=; rewrite U.
have [|k1 [s1 [[t1 M le] R1 lt]]] := pass_does R; first by rewrite U.
have [|t [k' [s' [Run le' R' F]]]] := IH k1 s1 _ R1; first exact: leq_trans lt lN.
exists (t1 ++ t), k', s'; split=> // [budget|]; last first.
  by rewrite size_cat (leq_trans (leq_add le le')) // -mulSn leq_mul2r lt orbT.
have -> m : perform m (Done k) s = perform m (pass k) s.
  by case: m => [|m] /=; rewrite U; have [a [f ->]] := pass_acts k.
by rewrite size_cat -addnA (perform_gives _ M) Run.
Qed.
End Repeated.

Lemma perform_as_plan (B : eqType) (L : lighthouse view B) pol (G : combinatorial_map) hand
    budget p (d : G) lying :
  carry hand (proceed (fun k => as_plan (one_pass L pol k))) budget (as_plan p) (d, lying)
  = let: (t, e, z) := machine L pol motion (fun d => view_of (d, lying)) budget p d in
    ([seq (Leave s.1, s.2) | s <- t], e, (z, lying)).
Proof.
have E q : proceed (fun k => as_plan (one_pass L pol k)) (as_plan q)
    = match next L pol q with inl e => inr e | inr (k, f) => inl (Leave k, fun o => as_plan (f o)) end.
  by case: q => //= k; case: (unexplored k) => // _ _; case: (one_pass L pol k).
elim: budget p d => [|n IH] p d /=; rewrite E; case: (next L pol p) => [e|[k f]] //=.
by rewrite IH; case: (machine _ _ _ _ _ _ _) => [[? ?] ?].
Qed.
