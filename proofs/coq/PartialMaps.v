(* ---------------------------------------------------------------------------------------------
   Partial maps: what an explorer knows, S and U, and the invariants I-1 and I-2.   Sections IV, V

   S numbers the vertices it holds 0, 1, ... in the order of discovery; 0 is v0.
     dart                 here: a dart of S, (number of its vertex, place clockwise).  The places
                          are counted from the dart by which the vertex was discovered; at v0 from
                          the dart that the robot faced at the start.
     partial_map          degrees: the degree of each vertex;  links: the explored darts, each
                          with the dart at the other end of its edge (both directions are listed).
     known S e            e is a dart of a vertex of S.
     partner S e          the other end of an explored dart.
     explored S e         e is in S as the end of an explored edge: its other end is known.
     is_open S e          e is known and not explored: the set of these is the paper's U.
     open_darts S         U as a list: by vertex, then clockwise.
     turn S k e           the k-th dart clockwise from e.
     follow S w e         the dart reached in S by the motions w from e; None where w leaves S.
     expected_percept     what a robot must sense in the dart e if S is right; b: the bearing at
                          the start.  expected_percepts: along motions, the paper's P^E.
     add_loop S e h       loop augmentation, lines 18-19: the edge e/h; h leaves U with e.
     add_vertex S e k     non-loop augmentation, lines 20-21: a new vertex of degree k behind e;
                          the robot came in by its dart 0, new_dart S.
   None of this mentions a world.  In a map G with start dart v0:
     phi v0 r e           the dart of G that e stands for, where r lists, vertex by vertex, the
                          dart that place 0 stands for: phi is the paper's map from S to G.
     embedded v0 S r      S is embedded in G by phi.
     explored_part        G_s, the explored subgraph: the darts of G that explored darts stand
                          for.
     at_explored_vertex   the dart lies at v0 or at a vertex with a dart in G_s.
     I1, I2               the paper's invariants; invariant_I1, invariant_I2: they follow from
                          `embedded`.
     complete_map         phi is onto, and every dart of S has its partner: S is the whole map.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition dart := (nat * nat)%type.

Record partial_map := PartialMap { degrees : seq nat; links : seq (dart * dart) }.

Definition degree_in S v := nth 0 (degrees S) v.
Definition known S (e : dart) := (e.1 < size (degrees S)) && (e.2 < degree_in S e.1).
Definition partner S e := ohead [seq p.2 | p <- links S & p.1 == e].
Definition explored S e := e \in unzip1 (links S).
Definition is_open S e := known S e && ~~ explored S e.
Definition darts S :=
  flatten [seq [seq (v, i) | i <- iota 0 (degree_in S v)] | v <- iota 0 (size (degrees S))].
Definition open_darts S : seq dart := [seq e <- darts S | is_open S e].

Definition turn S k (e : dart) : dart := (e.1, (e.2 + k) %% degree_in S e.1).
Fixpoint follow S w e :=
  if w is k :: w' then
    if partner S (turn S k e) is Some f then follow S w' f else None
  else Some e.

Definition expected_percept b S (e : dart) : percept :=
  (degree_in S e.1,
   if e.1 == 0 then Some ((b + (degree_in S 0 - e.2)) %% degree_in S 0) else None).
Fixpoint expected_percepts b S w e : seq percept :=
  expected_percept b S e ::
  (if w is k :: w' then
     if partner S (turn S k e) is Some f then expected_percepts b S w' f else [::]
   else [::]).

Definition initial_map k := PartialMap [:: k] [::].
Definition add_loop S e h := PartialMap (degrees S) [:: (e, h), (h, e) & links S].
Definition new_dart S : dart := (size (degrees S), 0).
Definition add_vertex S e k :=
  PartialMap (rcons (degrees S) k) [:: (e, new_dart S), (new_dart S, e) & links S].

(* ---- The lists ---- *)
Lemma mem_darts S e : (e \in darts S) = known S e.
Proof.
apply/flatten_mapP/andP=> [[v]|[l1 l2]].
  by rewrite mem_iota /= => lv /mapP[i]; rewrite mem_iota /= => li ->.
by exists e.1; rewrite ?mem_iota //; apply/mapP; exists e.2; rewrite ?mem_iota // -surjective_pairing.
Qed.

Lemma darts_uniq S : uniq (darts S).
Proof.
rewrite /darts; elim: (iota 0 _) (iota_uniq 0 (size (degrees S))) => //= v s IH /andP[vs U].
rewrite cat_uniq IH // map_inj_uniq ?iota_uniq // => [|i j [] //]; rewrite andbT /=.
apply/hasPn=> e /flatten_mapP[v' v's /mapP[i _ ->]]; apply/mapP=> -[j _ [E _]].
by rewrite -E v's in vs.
Qed.

Lemma mem_open_darts S e : (e \in open_darts S) = is_open S e.
Proof. by rewrite mem_filter mem_darts andb_idr // => /andP[]. Qed.

Lemma open_darts_uniq S : uniq (open_darts S).
Proof. by rewrite filter_uniq ?darts_uniq. Qed.

Lemma known_turn S k e : known S e -> known S (turn S k e).
Proof. by case/andP=> l1 l2; rewrite /known l1 ltn_mod (leq_ltn_trans _ l2). Qed.

Lemma partnerP S e f : partner S e = Some f -> (e, f) \in links S.
Proof.
rewrite /partner; case E: [seq _ | _ <- _ & _] => [|x s] //= [<-].
have: x \in x :: s by rewrite inE eqxx.
rewrite -E => /mapP[[a c]]; rewrite mem_filter => /andP[/eqP /= <- m] -> //.
Qed.

Lemma exploredP S e : explored S e -> exists f, (e, f) \in links S.
Proof. by case/mapP=> -[a c] m /= ->; exists c. Qed.

Lemma partner_total S e : explored S e -> exists f, partner S e = Some f.
Proof.
case/exploredP=> f m; rewrite /partner; case E: [seq _ | _ <- _ & _] => [|y s]; last by exists y.
by have: f \in [seq p.2 | p <- links S & p.1 == e];
  [apply/mapP; exists (e, f); rewrite // mem_filter eqxx | rewrite E].
Qed.

Lemma known_rcons S k l f : known S f -> known (PartialMap (rcons (degrees S) k) l) f.
Proof.
by case/andP=> l1 l2; rewrite /known /degree_in /= size_rcons nth_rcons l1 (ltnW (n:=_.+1)) //=.
Qed.

Lemma new_unknown S : ~~ known S (new_dart S).
Proof. by rewrite /known /= ltnn. Qed.

(* ---- S in the world ---- *)
Section Embedding.
Variables (G : combinatorial_map) (v0 : G).

Definition phi (r : seq G) (e : dart) := iter e.2 sigma (nth v0 r e.1).

Record embedded S (r : seq G) : Prop := Embedded {
  embedded_degrees : degrees S = [seq degree x | x <- r];
  embedded_start : 0 < size r /\ nth v0 r 0 = v0;
  embedded_apart : forall v w, v < size r -> w < size r ->
    at_same_vertex (nth v0 r v) (nth v0 r w) -> v = w;
  embedded_links : forall e f, (e, f) \in links S ->
    [/\ known S e, known S f, alpha (phi r e) = phi r f & (f, e) \in links S];
  embedded_once : uniq (unzip1 (links S));
  embedded_entered : forall v, 0 < v < size r -> exists i, explored S (v, i) }.

Lemma embedded_initial : embedded (initial_map (degree v0)) [:: v0].
Proof. by split=> // [[|v] [|w]|[|v]]. Qed.

Section Embedded.
Variables (S : partial_map) (r : seq G).
Hypothesis I : embedded S r.

Lemma size_degrees : size (degrees S) = size r.
Proof. by rewrite (embedded_degrees I) size_map. Qed.

Lemma degree_phi v : v < size r -> degree_in S v = degree (nth v0 r v).
Proof. by move=> lt; rewrite /degree_in (embedded_degrees I) (nth_map v0). Qed.

Lemma knownP e : known S e -> e.1 < size r /\ e.2 < degree (nth v0 r e.1).
Proof. by case/andP; rewrite size_degrees => l1 l2; rewrite -degree_phi. Qed.

Lemma phi_vertex e : at_same_vertex (nth v0 r e.1) (phi r e).
Proof. exact: fconnect_iter. Qed.

Lemma same_vertex e f : known S e -> known S f -> at_same_vertex (phi r e) (phi r f) -> e.1 = f.1.
Proof.
move=> /knownP[l1 _] /knownP[k1 _] c; apply: (embedded_apart I) => //.
apply: connect_trans (phi_vertex e) (connect_trans c _).
by rewrite -/(at_same_vertex _ _) at_same_vertex_sym; exact: phi_vertex.
Qed.

Lemma phi_inj e f : known S e -> known S f -> phi r e = phi r f -> e = f.
Proof.
move=> ke kf E; have [l1 l2] := knownP ke; have [k1 k2] := knownP kf.
have v1 : e.1 = f.1 by apply: same_vertex; rewrite // E /at_same_vertex connect0.
have v2 : e.2 = f.2.
  by rewrite -(findex_iter l2) -[iter _ _ _]/(phi r e) E /phi v1 findex_iter.
by rewrite (surjective_pairing e) v1 v2 -surjective_pairing.
Qed.

Lemma phi_turn k e : known S e -> phi r (turn S k e) = iter k sigma (phi r e).
Proof.
move=> /knownP[l1 _]; rewrite /phi /turn /= degree_phi // turn_modulo_degree.
by rewrite addnC iterD.
Qed.

Lemma follow_phi w e f : known S e -> follow S w e = Some f ->
  known S f /\ walk w (phi r e) = phi r f.
Proof.
elim: w e => [|k w IH] e ke /=; first by case=> <-.
case L: (partner S (turn S k e)) => [g|] // R.
have [_ kg ag _] := embedded_links I (partnerP L).
by rewrite /motion -phi_turn // ag; exact: IH.
Qed.

Lemma known_start : known S (0, 0).
Proof.
have [r0 _] := embedded_start I.
by rewrite /known /= size_degrees r0 degree_phi // degree_gt0.
Qed.

Lemma on_vertex x v : v < size r -> at_same_vertex (nth v0 r v) x ->
  exists2 e, known S e & phi r e = x.
Proof.
move=> lv c; exists (v, findex sigma (nth v0 r v) x); last by rewrite /phi /= iter_findex.
by rewrite /known /= size_degrees lv degree_phi //= findex_max.
Qed.

Lemma partner_known x y : partner S x = Some y -> known S y.
Proof. by move/partnerP/(embedded_links I) => []. Qed.

(* where the other end of an open dart can be: a different open dart, or nowhere in S (I-2) *)
Lemma other_end e f : is_open S e -> known S f -> alpha (phi r e) = phi r f ->
  is_open S f /\ f != e.
Proof.
move=> /andP[ke oe] kf E; split; last first.
  by apply/eqP=> fe; move: (alpha_neq (phi r e)); rewrite E fe eqxx.
rewrite /is_open kf; apply/negP=> /exploredP[g m]; have [_ kg ag mg] := embedded_links I m.
have ge : g = e by apply: phi_inj => //; rewrite -ag -E alphaK.
by case/negP: oe; rewrite -ge; apply/mapP; exists (g, f).
Qed.

Lemma embedded_loop e h : is_open S e -> is_open S h -> h != e -> alpha (phi r e) = phi r h ->
  embedded (add_loop S e h) r.
Proof.
move=> /andP[ke oe] /andP[kh oh] he E; split; try by case: I.
- move=> x y; rewrite !inE => /or3P[/eqP[-> ->]|/eqP[-> ->]|m].
  + by rewrite eqxx orbT.
  + by rewrite eqxx -E alphaK; split.
  + by have [a1 a2 a3 a4] := embedded_links I m; split; rewrite // a4 !orbT.
- by rewrite /= inE negb_or eq_sym he oe oh (embedded_once I).
- move=> v /(embedded_entered I)[i m]; exists i; rewrite /explored /= !inE; apply/or3P.
  exact: Or33.
Qed.

Lemma phi_rcons (x : G) f : known S f -> phi (rcons r x) f = phi r f.
Proof. by case/knownP=> l1 _; rewrite /phi nth_rcons l1. Qed.

Lemma phi_new (x : G) : phi (rcons r x) (new_dart S) = x.
Proof. by rewrite /phi /new_dart /= size_degrees nth_rcons ltnn eqxx. Qed.

Lemma known_new (x : G) l : known (PartialMap (rcons (degrees S) (degree x)) l) (new_dart S).
Proof. by rewrite /known /degree_in /= size_rcons nth_rcons ltnn eqxx ltnSn degree_gt0. Qed.

Lemma outside (x : G) v : (forall f, known S f -> phi r f <> x) -> v < size r ->
  ~~ at_same_vertex (nth v0 r v) x.
Proof.
move=> out lv; apply/negP=> c; apply: (out (v, findex sigma (nth v0 r v) x)).
  by rewrite /known /= size_degrees lv degree_phi //= findex_max.
by rewrite /phi /= iter_findex.
Qed.

Lemma embedded_vertex e : is_open S e -> let x := alpha (phi r e) in
  (forall f, known S f -> phi r f <> x) -> embedded (add_vertex S e (degree x)) (rcons r x).
Proof.
move=> /andP[ke oe] x out.
have kf : known (add_vertex S e (degree x)) (new_dart S) by exact: (known_new x).
have kr f : known S f -> known (add_vertex S e (degree x)) f by exact: known_rcons.
split.
- by rewrite /= (embedded_degrees I) map_rcons.
- by have [p q] := embedded_start I; rewrite size_rcons nth_rcons p.
- move=> v w; rewrite size_rcons !ltnS !nth_rcons.
  rewrite leq_eqVlt => /orP[/eqP->|lv]; rewrite leq_eqVlt => /orP[/eqP->|lw]; rewrite ?ltnn ?eqxx //.
  + by rewrite lw -/(at_same_vertex _ _) at_same_vertex_sym => c; case/negP: (outside out lw).
  + by rewrite lv => c; case/negP: (outside out lv).
  + by rewrite lv lw; exact: (embedded_apart I).
- move=> y z; rewrite !inE => /or3P[/eqP[-> ->]|/eqP[-> ->]|m].
  + by rewrite kf kr // (phi_rcons x ke) (phi_new x) eqxx orbT.
  + by rewrite kf kr // (phi_rcons x ke) (phi_new x) /x alphaK eqxx.
  + have [a1 a2 a3 a4] := embedded_links I m.
    by rewrite !kr // !phi_rcons // a4 !orbT.
- have lf : new_dart S \notin unzip1 (links S).
    apply/negP=> /exploredP[g m]; have [k1 _ _ _] := embedded_links I m.
    by move: (new_unknown S); rewrite k1.
  rewrite /= inE negb_or oe lf (embedded_once I) andbT /=.
  by rewrite andbT; apply/eqP=> ef; move: (new_unknown S); rewrite -ef ke.
- move=> v /andP[gt0]; rewrite size_rcons ltnS leq_eqVlt => /orP[/eqP->|lv].
    by exists 0; rewrite /explored /= !inE /new_dart size_degrees eqxx orbT.
  by have [|i m] := @embedded_entered _ _ I v;
    [by rewrite gt0 | exists i; rewrite /explored /= !inE; apply/or3P/Or33].
Qed.

Lemma size_links : size (links S) <= #|G|.
Proof.
rewrite -(size_map fst) -(size_map (phi r)) -(card_uniqP _) ?max_card //.
rewrite map_inj_in_uniq ?(embedded_once I) // => e f /exploredP[g m] /exploredP[g' m'].
have [k1 _ _ _] := embedded_links I m; have [k2 _ _ _] := embedded_links I m'; exact: phi_inj.
Qed.

(* ---- I-1: S is isomorphic to G_s, the explored subgraph of G ---- *)
Definition explored_part := [seq phi r e | e <- unzip1 (links S)].
Definition at_explored_vertex d :=
  at_same_vertex v0 d || has (fun x => at_same_vertex x d) explored_part.

Lemma mem_explored_part e : known S e -> (phi r e \in explored_part) = explored S e.
Proof.
move=> ke; apply/mapP/idP=> [[f m E]|m]; last by exists e.
have [g m'] := exploredP m; have [kf _ _ _] := embedded_links I m'.
by rewrite /explored (phi_inj ke kf E).
Qed.

Lemma at_explored_vertexP d : reflect (exists2 e, known S e & phi r e = d) (at_explored_vertex d).
Proof.
have [r0 n0] := embedded_start I; apply: (iffP orP) => [[c|/hasP[x]]|[e ke <-]].
- by apply: (on_vertex r0); rewrite n0.
- case/mapP=> e /exploredP[f m] -> c; have [ke _ _ _] := embedded_links I m.
  have [l _] := knownP ke; apply: (on_vertex l); exact: connect_trans (phi_vertex e) c.
have [l _] := knownP ke; case: (posnP e.1) => [e0|e0].
  by left; have := phi_vertex e; rewrite e0 n0.
right; have [|i m] := @embedded_entered _ _ I e.1; first by rewrite e0.
apply/hasP; exists (phi r (e.1, i)); first exact: map_f.
apply: connect_trans (phi_vertex e); rewrite -/(at_same_vertex _ _) at_same_vertex_sym.
exact: phi_vertex (e.1, i).
Qed.

Definition I1 :=
  [/\ (* G_s is a set of whole edges, each found once *)
      uniq explored_part /\ forall d, (alpha d \in explored_part) = (d \in explored_part),
      (* phi is a bijection from the darts of S to the darts at the vertices of G_s *)
      forall d, at_explored_vertex d <-> exists2 e, known S e & phi r e = d,
      forall e f, known S e -> known S f -> phi r e = phi r f -> e = f,
      (* it keeps the cyclic orders: the edge-index condition *)
      forall k e, known S e -> phi r (turn S k e) = iter k sigma (phi r e)
      & (* and the edges of S are those of G_s *)
      forall e, known S e -> (phi r e \in explored_part) = explored S e
        /\ forall f, partner S e = Some f -> known S f /\ alpha (phi r e) = phi r f].

Theorem invariant_I1 : I1.
Proof.
have kl e f : (e, f) \in links S -> known S e by case/(embedded_links I).
have half d : d \in explored_part -> alpha d \in explored_part.
  case/mapP=> e /exploredP[f m] ->; have [_ _ -> m'] := embedded_links I m.
  by apply: map_f; apply/mapP; exists (f, e).
split; first split.
- rewrite map_inj_in_uniq ?(embedded_once I) // => e f /exploredP[e' m] /exploredP[f' m'].
  by apply: phi_inj; [exact: kl m | exact: kl m'].
- by move=> d; apply/idP/idP=> [/half|/half //]; rewrite alphaK.
- by move=> d; split=> /at_explored_vertexP.
- exact: phi_inj.
- by move=> k e; exact: phi_turn.
move=> e ke; split; first exact: mem_explored_part.
by move=> f /partnerP m; have [_ kf E _] := embedded_links I m.
Qed.

(* ---- I-2: U is, by phi, the set of the unexplored darts of G that lie at a vertex of G_s ---- *)
Definition I2 :=
  (forall d, at_explored_vertex d && (d \notin explored_part) <->
     exists2 e, e \in open_darts S & phi r e = d) /\
  (forall e f, e \in open_darts S -> f \in open_darts S -> phi r e = phi r f -> e = f).

Theorem invariant_I2 : I2.
Proof.
split=> [d|e f].
  split=> [/andP[/at_explored_vertexP[e ke <-]]|[e]].
    by rewrite mem_explored_part // => ne; exists e; rewrite // mem_open_darts /is_open ke.
  rewrite mem_open_darts => /andP[ke ne] <-; rewrite mem_explored_part // ne andbT.
  by apply/at_explored_vertexP; exists e.
by rewrite !mem_open_darts => /andP[ke _] /andP[kf _]; exact: phi_inj.
Qed.

(* ---- When U is empty: S is the whole map.  Section V, item 4 ---- *)
Definition complete_map :=
  [/\ forall d, exists2 e, known S e & phi r e = d,
      forall e f, known S e -> known S f -> phi r e = phi r f -> e = f,
      forall e, known S e -> phi r (turn S 1 e) = sigma (phi r e),
      forall e, known S e ->
        exists f, [/\ partner S e = Some f, known S f & phi r f = alpha (phi r e)]
      & phi r (0, 0) = v0].

Theorem complete_when_nothing_open : (forall e, ~~ is_open S e) -> complete_map.
Proof.
have [r0 n0] := embedded_start I; move=> nopen.
have L e : known S e -> exists f, [/\ partner S e = Some f, known S f & phi r f = alpha (phi r e)].
  move=> ke; move: (nopen e); rewrite /is_open ke /= negbK => /partner_total[f lf].
  by exists f; have [_ kf a _] := embedded_links I (partnerP lf).
split=> //; [|exact: phi_inj|by move=> e ke; rewrite phi_turn].
apply: (@everywhere _ (fun d => exists2 e, known S e & phi r e = d) v0).
- by exists (0, 0); first exact: known_start.
- by move=> _ [e ke <-]; exists (turn S 1 e); [exact: known_turn | rewrite phi_turn].
- by move=> _ [e ke <-]; have [f [_ kf pf]] := L _ ke; exists f.
Qed.

(* ---- Counting ---- *)
Lemma size_vertices : size (degrees S) <= vertices G.
Proof.
rewrite size_degrees /vertices /n_comp_mem -(size_map (froot sigma)).
have sym := fconnect_sym (@sigma_inj G); rewrite -(card_uniqP _); last first.
  rewrite map_inj_in_uniq.
    apply/(uniqP v0) => i j; rewrite !inE => li lj E; apply: (embedded_apart I) => //.
    by rewrite E; exact: connect0.
  move=> x y /(nthP v0)[i li <-] /(nthP v0)[j lj <-] /eqP; rewrite (root_connect sym).
  by move/(embedded_apart I) => /(_ li lj) ->.
apply: subset_leq_card; apply/subsetP=> x /mapP[y _ ->].
by rewrite !inE andbT; exact: (roots_root sym).
Qed.

Lemma complete_links : complete_map -> #|G| <= size (links S).
Proof.
case=> sur _ _ L _; rewrite -(size_map fst) -(size_map (phi r)).
apply: leq_trans (card_size _); apply: subset_leq_card; apply/subsetP=> d _.
have [e ke <-] := sur d; apply: map_f; have [f [lf _ _]] := L e ke.
by apply/mapP; exists (e, f); rewrite ?partnerP.
Qed.

Lemma complete_vertices : complete_map -> vertices G <= size (degrees S).
Proof.
case=> sur _ _ _ _; rewrite size_degrees -(size_map (froot sigma)) /vertices /n_comp_mem.
apply: leq_trans (card_size _); apply: subset_leq_card; apply/subsetP=> x.
have sym := fconnect_sym (@sigma_inj G).
rewrite !inE andbT => /eqP rx; have [e ke E] := sur x; have [l1 _] := knownP ke.
apply/mapP; exists (nth v0 r e.1); first exact: mem_nth.
by rewrite -rx; apply/eqP; rewrite (root_connect sym) sym -E; exact: phi_vertex.
Qed.

(* open and explored darts of S stand for different darts of G *)
Lemma open_and_explored hs : uniq hs -> (forall h, h \in hs -> is_open S h) ->
  size hs + size (links S) <= #|G|.
Proof.
move=> U O; rewrite -(size_map fst (links S)) -size_cat -(size_map (phi r)).
have kn e : e \in hs ++ unzip1 (links S) -> known S e.
  rewrite mem_cat => /orP[/O/andP[]//|/exploredP[g m]].
  by case: (embedded_links I m).
rewrite -(card_uniqP _) ?max_card // map_inj_in_uniq; last first.
  by move=> e f /kn ke /kn kf; exact: phi_inj.
rewrite cat_uniq U (embedded_once I) andbT; apply/hasPn=> e le.
by apply/negP=> /O/andP[_]; rewrite /explored le.
Qed.
End Embedded.
End Embedding.
