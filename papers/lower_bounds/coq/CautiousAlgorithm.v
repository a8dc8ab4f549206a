(* ---------------------------------------------------------------------------------------------
   Algorithm 1 is cautious, under every policy.                                       Sections IV, VI

   In a bouquet at a distance S has two vertices at most, so a test makes one motion, and if that does not lead to
   v0 the robot goes back.

     placed p, near p     what is known is the dart; it is at most one edge away from the end of a loop.
     wary p d s Q         program p, run from dart d with the knowledge s, goes back wherever the robot is Deep; Q
                          holds of its result, dart and knowledge.
     tests_wary, walk_wary, pass_wary     the tests of a pass, the way to its edge, and the pass are wary.
     cautious_algorithm1  so Algorithm 1 is cautious, finds the map of every world, and makes c(2c+1) motions.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers PartialMaps Paths Pass Algorithm.
From Allworlds Require Import Routes Queue Execution OnePass Refinement PathWorlds.
From Bounds Require Import Gluings Bouquets Cautious.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Wary.
Variables (k : nat) (pol : policy) (a : loop_matching k).
Local Notation loop_end := 'I_(k.*2.+2).
Local Notation dart := (loop_end + bool)%type.
Local Notation at_v0 := (at_v0 k).
Local Notation W := (hanging a).
Local Notation senses := (@percept_of W).
Local Notation loop_ring := (loop_ring k).
Local Notation loop_knowledge := (loop_knowledge k).
Local Notation program := (program percept).
Implicit Types (d : W) (s : loop_knowledge) (K : knowledge).

Definition placed (p : whereabouts k) := match p with Home | Inside _ => true | _ => false end.
Definition near (p : whereabouts k) := if p is Deep _ _ then false else true.
Definition can_return (p : whereabouts k) := if p is Lost _ o then o %% loop_ring == 0 else true.

Lemma placed_near s j o : placed (whereabouts_of s) -> near (whereabouts_of (knows_after s j o)).
Proof.
rewrite /knows_after; case: (whereabouts_of s) => //= d _; case: (turned_by j d) => [e|] //.
by case: (end_told s e).
Qed.

Lemma near_returns d s j : true_of a d s -> near (whereabouts_of s) ->
  can_return (whereabouts_of (knows_after s j (senses (motion j d)))).
Proof.
case=> tp ti _ _ _; rewrite /knows_after; case P: (whereabouts_of s) tp ti => [|x|e o|e o] //= tp ti _.
  by case: (turned_by j x) => [e|] //; case: (end_told s e) => //= *; rewrite mod0n.
case: eqP => // nz; case B: (bearing _) => [b|] //=.
case: pickP => // none; case: (motion j d =P at_v0) => [h|n]; last by rewrite no_bearing in B.
have := none (val a e); suff -> : turned_by (o + j) (inl (val a e)) = inr true by rewrite eqxx.
by apply: (inv_inj (@alphaK W)); rewrite -turned_byD -[RHS]h; move: tp => /= ->.
Qed.

Lemma back_near s o : can_return (whereabouts_of s) -> near (whereabouts_of (knows_after s 0 o)).
Proof.
rewrite /knows_after; case: (whereabouts_of s) => [|d|e o'|e o'] //=; last by rewrite addn0 => ->.
by case: d => [e|] //; case: (end_told s e).
Qed.

Fixpoint wary A (p : program A) d s (Q : A -> W -> loop_knowledge -> Prop) : Prop :=
  match p with
  | Return x => Q x d s
  | Go j f => (forall e o, whereabouts_of s = Deep e o -> j %% loop_ring = 0) /\
      let d' := motion j d in wary (f (senses d')) d' (knows_after s j (senses d')) Q
  end.

Lemma wary_bind A B (p : program A) (f : A -> program B) d s Q R : wary p d s Q ->
  (forall x d' s', Q x d' s' -> wary (f x) d' s' R) -> wary (bind p f) d s R.
Proof. by move=> H F; elim: p d s H => [x|j g IH] d s /=; [exact: F | case=> b /IH]. Qed.

Lemma wary_weak A (p : program A) d s (Q R : A -> W -> loop_knowledge -> Prop) : wary p d s Q ->
  (forall x d' s', Q x d' s' -> R x d' s') -> wary p d s R.
Proof. by move=> H F; elim: p d s H => [x|j g IH] d s /=; [exact: F | case=> b /IH]. Qed.

(* what it comes to is what is executed, and stays true *)
Lemma wary_exec A (p : program A) d s Q x z t : true_of a d s -> wary p d s Q -> exec senses p d = (x, z, t) ->
  wary p d s (fun x' z' s' => [/\ x' = x, z' = z, s' = foldl (fun s q => knows_after s q.1 q.2) s t,
    true_of a z' s' & Q x' z' s']).
Proof.
elim: p d s t => [y|j g IH] d s t T /=; first by move=> q [<- <- <-].
case=> back H; case E: (exec _ _ _) => [[x1 z1] t1] [ex ez <-]; subst x1 z1.
by split=> //; exact: (IH _ _ _ _ (learns_true T back) H E).
Qed.

(* ---- The tests of a pass ---- *)
Lemma tests_wary K o hs c d s : true_of a d s -> near (whereabouts_of s) ->
  (forall h, h \in hs -> size (way_home pol K h).1 < 2) ->
  wary (test_all directional pol K o hs c) d s (fun _ _ _ => True).
Proof.
elim: hs c d s => [|h hs IH] c d s T N H //; rewrite [test_all _ _ _ _ _ _]/=.
have H' h' : h' \in hs -> size (way_home pol K h').1 < 2 by move=> m; apply: H; rewrite inE m orbT.
have := H h (mem_head _ _); case: (way_home pol K h) => -[|j [|//]] f _ /=.
  by case: eqP => _ //=; exact: IH.
case: eqP => _ /=; last exact: IH.
have back0 e o' : whereabouts_of s = Deep e o' -> (c + j) %% loop_ring = 0 by move=> P; rewrite P in N.
pose d1 := motion (c + j) d; pose s1 := knows_after s (c + j) (senses d1); split=> //.
have T1 : true_of a d1 s1 by exact: (learns_true T).
have C1 : can_return (whereabouts_of s1) by exact: near_returns.
have go_back_wary p : (forall c' d' s', true_of a d' s' -> near (whereabouts_of s') -> wary (p c') d' s' (fun _ _ _ => True)) ->
    wary (bind (go_back _ [:: (j, o.1)] 0) p) d1 s1 (fun _ _ _ => True).
  move=> H2 /=; split; first by rewrite mod0n.
  by apply: H2; [apply: (learns_true (j := 0) T1) => *; exact: mod0n | exact: back_near].
case: (map _ _) => [|e1 es] /=; first by apply: go_back_wary => *; exact: IH.
by case: eqP => _ //; apply: go_back_wary => *; exact: IH.
Qed.

(* ---- The way to the next edge ---- *)
Lemma home_is_known d s : true_of a d s -> d = at_v0 -> whereabouts_of s = Home k.
Proof. by case=> _ ti _ _ _ E; case: (whereabouts_of s) ti => // [x|e o|e o] []. Qed.

Lemma walk_wary w j c d s : true_of a d s -> (w = [::] /\ placed (whereabouts_of s)) \/ (size w < 2 /\ d = at_v0) ->
  wary (walk_to percept w j c) d s (fun _ _ s' => near (whereabouts_of s')).
Proof.
move=> T H; have N : placed (whereabouts_of s) by case: H => [[]//|[_ /(home_is_known T)->]].
have back e o i : whereabouts_of s = Deep e o -> i %% loop_ring = 0 by move=> P; rewrite P in N.
have E2 : w <> [::] -> whereabouts_of s = Home k by case: H => [[-> _ /(_ erefl)]//|[_ /(home_is_known T)->]].
have sw : size w < 2 by case: H => [[->]|[]].
case: w sw E2 H => [|i [|//]] _ E2 _ /=; split; try by move=> e o; exact: back.
  exact: placed_near.
have P j' o : placed (whereabouts_of (knows_after s j' o)) by rewrite /knows_after E2.
split; last exact: placed_near.
by move=> e o Q; have := P (c + i) (senses (motion (c + i) d)); rewrite Q.
Qed.

(* ---- A pass ---- *)
Definition first_link n := add_vertex (initial_map 1) (0, 0) n.
Lemma open_behind m e : is_open (first_link m) e -> e.1 = 1.
Proof.
case: e => -[|[|v]] i //; rewrite /is_open /known /degree_in /= ?andbF //.
by case: i => // i; rewrite ltnS.
Qed.

Definition between K d s := [/\ true_of a d s, exists2 c, sound c & knows K c d &
  d = at_v0 \/ placed (whereabouts_of s) /\ exists n, known_map K = first_link n /\ at_dart K = (1, 0)].

Lemma at_v0P d : at_same_vertex (start : W) d -> d = at_v0.
Proof. by move=> v; case: (d =P at_v0) => // /apart_from_v0; rewrite v. Qed.

Section OnePass.
Variables (K : knowledge) (c : configuration W) (d : W).
Hypotheses (Ok : sound c) (Kn : knows K c d) (U : unexplored K != [::]).
Local Notation S := (known_map K).
Local Notation e := (next_edge pol K).
Local Notation way := (way_to pol K e).

Lemma ways : [/\ is_open S e, [/\ follow S way.1 (at_dart K) = Some way.2, way.2.1 = e.1 & size way.1 < size (degrees S)],
  size (degrees S) <= 2 & forall o h, h \in hypotheses directional pol K e o -> size (way_home pol K h).1 < size (degrees S)].
Proof.
have [r [I kh _ Rc]] := Ok; have [_ SE hE [_ mU] _] := Kn; rewrite SE hE in I kh Rc.
have Hl x y : partner S x = Some y -> known S y by move/partnerP/(embedded_links I) => [].
have oe : is_open S e.
  by rewrite -mU /next_edge; case: ifP => // _; case: (unexplored K) U => // *; exact: mem_head.
have [ke _] := andP oe; split=> //.
- apply: route_or_elseP => //; have [[w [f [Rw f0]]] _] := Rc _ kh; have [_ A] := Rc e ke.
  by have [kf _] := follow_phi I kh Rw; exact: (joined_trans Rw (joined_turn A kf f0)).
- by have [_ <- _] := hanging_sizes a; exact: size_vertices I.
move=> o h; set H := hypotheses _ _ _ _ _ => mh; have kh' : known S h.
  have : h \in unexplored K; last by rewrite mU => /andP[].
  move: mh; rewrite /H /hypotheses; set H' := [seq h <- _ | _]; have sub : {subset H' <= unexplored K}.
    by move=> x; rewrite mem_filter => /andP[].
  by case: ifP => [/perm_mem->|_]; exact: sub.
by have [_ _] := route_or_elseP kh' Hl (choose_home pol K h) (proj1 (Rc h kh')).
Qed.
End OnePass.

Lemma wary_true A (p : program A) d s Q : true_of a d s -> wary p d s Q ->
  wary p d s (fun x z s' => true_of a z s' /\ Q x z s').
Proof.
move=> T H; case E: (exec senses p d) => [[x z] t].
by apply: wary_weak (wary_exec T H E) _ => x' z' s' [].
Qed.

Lemma one_vertex_known S r : embedded (start : W) S r -> size (degrees S) <= 1 -> S = initial_map 1.
Proof.
move=> I s1; have [r0 n0] := embedded_start I; have sr : size r = 1.
  by apply/eqP; rewrite eqn_leq r0 -(size_degrees I) s1.
have dS : degrees S = [:: 1].
  rewrite (embedded_degrees I); case: r sr n0 {I r0} => [//|x [|//]] _ /= ->.
  by have [_ _ ->] := hanging_sizes a.
have only f : known S f -> f = (0, 0) by case: f => -[|v] [|i] //; rewrite /known /degree_in dS.
case: S dS only I {s1} => ds ls /= -> only I; congr PartialMap; case: ls I only => // -[e f] ls I only.
have [ke kf E _] := embedded_links I (mem_head _ _).
by have := alpha_neq (phi start r e); rewrite E (only _ ke) (only _ kf) eqxx.
Qed.

Lemma pass_wary K d s : between K d s -> unexplored K != [::] ->
  wary (one_pass directional pol K) d s between.
Proof.
case=> T [c Ok Kn] At U; have [K' [z [n [c' [[t [E sz]] P Kn']]]]] := one_pass_is_pass pol Ok Kn U.
have Ok' := pass_sound Ok P; have [oe [R g1 sw] n2 hw] := ways Ok Kn U; have [ke ne] := andP oe.
have W1 : wary (one_pass directional pol K) d s (fun _ _ _ => True).
  rewrite /one_pass; apply: wary_bind (wary_true T (walk_wary _ _ T _)) _.
    case: At => [->|[pl [m [SE hE]]]]; [by right; split=> //; exact: leq_trans sw n2 | left; split=> //].
    have e1 : (next_edge pol K).1 = 1 by apply: (open_behind (m := m)); rewrite -SE.
    move: R g1 sw; rewrite SE hE e1; case: (way_to pol K _) => -[|i [|i' w]] f //= R f1 _; move: R f1.
    by rewrite /partner /=; case: ifP => _ //= [<-].
  move=> o d' s' [T' N]; apply: (wary_bind (Q := fun _ _ _ => True)) => //.
  by apply: (tests_wary _ _ T' N) => h /hw lt; exact: leq_trans lt n2.
move/(wary_exec T)/(_ E)/wary_weak: W1; apply=> _ _ s' [-> -> sE T' _]; split=> //; first by exists c'.
have v0S y : due (due_turn K') z y -> at_same_vertex (start : W) y -> z = at_v0.
  move=> <- v; apply: at_v0P; apply: connect_trans v _; rewrite fconnect_sym; last exact: sigma_inj.
  exact: fconnect_iter.
have [_ E1 E2 _ du] := Kn'; have [r [I kh ph _]] := Ok'; have [_ SE _ _ _] := Kn.
case: P Ok E1 E2 du sz I kh ph SE => S x0 p w0 k0 ts => [h w f|] x [oS sw0 _] rj.
  move=> _ oh _ [Rw f0 _] _ _ E1 E2 du sz I kh ph SE.
  left; apply: (v0S _ du); rewrite [robot _]/= in ph *.
  have [_ <-] := embedded_start I; rewrite ph -f0; exact: phi_vertex.
move=> _ _ [r0 [/= I0 _ _ _]] E1 E2 _ sz I _ _ SE; right.
have := size_vertices I; have [_ -> _] := hanging_sizes a; rewrite /= size_rcons ltnS => s1.
have S0 := one_vertex_known I0 s1; have only f : known S f -> f = (0, 0).
  by case: f => -[|v] [|i] //; rewrite S0 /known /degree_in.
have ts0 : ts = [::].
  case: ts rj sz => // q ts rj _; exfalso; have [oq /eqP nq _ _] := rj q (mem_head _ _); apply: nq.
  by have [kq _] := andP oq; have [kS _] := andP oS; rewrite (only _ kq) (only _ kS).
have [kS _] := andP oS; rewrite (only _ kS) S0 in E1 E2.
split; last by exists (percept_of x).1; rewrite -E1 -E2.
have h0 : whereabouts_of s = Home k.
  case: At => [/(home_is_known T)//|[_ [m [Sm _]]]]; exfalso.
  by move: s1; rewrite [S]SE Sm.
have t1 : size t = 1 by move: sw0 sz; rewrite ts0 /tests_cost big_nil S0; case: (w0).
by case: t t1 sE {E sz} => [//|q [|//]] _ /= ->; rewrite /knows_after h0.
Qed.

(* ---- The explorer ---- *)
Local Notation X := (algorithm1 pol).
Local Notation sense := (Algorithm.sense directional pol).

Lemma next_wary p d s j : wary p d s between -> act directional pol p = Move j ->
  exists f, wary (Go j f) d s between /\ forall o, sense p o = f o.
Proof.
rewrite /act /Algorithm.sense; case: p => [K|i f] H /=; last by case=> <-; exists f.
case: (boolP (unexplored K == [::])) => [/eqP->//|U].
move: U (pass_wary H U); case: (unexplored K) => // x u _; case: (one_pass _ _ _) => // i f Wf [<-].
by exists f.
Qed.

Lemma gets_to_wary seen d s : gets_to X a seen d s -> exists p,
  (forall more, X (seen ++ more) = act directional pol (foldl sense p more)) /\ wary p d s between.
Proof.
elim=> [|{}seen {}d {}s j S [p [Xp Wp]] Xj].
  exists (Return (first_knowledge (senses at_v0))); split=> //.
  split=> //; last by left.
  by exists (initial W); [exact: sound_initial | split=> //=; [rewrite bearing_start | exact: queue_initial]].
set o := percept_of _; exists (sense p o); rewrite -(cats0 seen) Xp in Xj.
have [f [Wf fE]] := next_wary Wp Xj; case: Wf => _ H.
by split=> [more|]; [rewrite cat_rcons Xp | rewrite fE].
Qed.
End Wary.

Theorem cautious_algorithm1 k pol :
  [/\ cautious k (algorithm1 pol),
      (forall V : lighthouse_world, finds_map denote (algorithm1 pol) (rooted (@start V)) (@percept_of V)) &
  exists a : loop_matching k, forall fuel t e z,
  episode (algorithm1 pol) (rooted (@start (hanging a))) (@percept_of (hanging a)) fuel = (t, Some e, z) ->
  k.+1 * (2 * k.+1 + 1) <= size t].
Proof.
have finds (V : lighthouse_world) := right_finds_map (@algorithm1_right V pol).
suff careful : cautious k (algorithm1 pol) by split=> //; exact: cautious_needs careful finds.
move=> a seen d s e o j /gets_to_wary[p [Xp Wp]] P; rewrite -(cats0 seen) Xp => /(next_wary Wp)[f [Wf _]].
by case: Wf => back _; exact: back P.
Qed.
