; A model of the hypotheses of truth-matches-step.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows the three vertices, a0b0 and a1c0; B1 and C1 are open. k = 1, w is empty;
;   h = C1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(declare-datatypes ((Degree 0)) (((two))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun turn ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun marked ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun degree ((x Dart)) Degree two)
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun known ((x MapDart)) Bool true)
(define-fun explored ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x C0)))
(define-fun partner ((x MapDart)) MapDart
  (ite (= x A0) B0 (ite (= x A1) C0 (ite (= x B0) A0 (ite (= x B1) C1 (ite (= x C0) A1 B1))))))
(define-fun turn_map ((x MapDart)) MapDart
  (ite (= x A0) A1 (ite (= x A1) A0 (ite (= x B0) B1 (ite (= x B1) B0 (ite (= x C0) C1 C0))))))
(define-fun home ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun degree_map ((x MapDart)) Degree two)
(define-fun leads_w ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun leads_kw ((x MapDart)) Bool (or (= x B1) (= x C1)))
(define-fun match_w ((x0 MapDart) (x1 Dart)) Bool
  (or (and (= x0 A0) (= x1 a0)) (and (= x0 A1) (= x1 a1))))
(define-fun match_kw ((x0 MapDart) (x1 Dart)) Bool
  (or (and (= x0 B1) (= x1 b1)) (and (= x0 C1) (= x1 c1))))
(define-fun h () MapDart C1)

(assert (forall ((e MapDart))
  (=> (known e) (and (known (turn_map e)) (= (phi (turn_map e)) (turn (phi e)))))))
(assert (forall ((e MapDart))
  (=> (explored e) (and (known (partner e)) (= (phi (partner e)) (alpha (phi e)))))))
(assert (forall ((e MapDart))
  (=> (known e) (and (= (degree_map e) (degree (phi e))) (= (home e) (marked (phi e)))))))
(assert (forall ((e MapDart))
  (= (leads_kw e) (and (explored (turn_map e)) (leads_w (partner (turn_map e)))))))
(assert (forall ((e MapDart) (d Dart))
  (= (match_kw e d)
     (and (= (degree_map e) (degree d)) (= (home e) (marked d))
          (explored (turn_map e)) (match_w (partner (turn_map e)) (alpha (turn d)))))))
(assert (forall ((e MapDart)) (=> (and (known e) (leads_w e)) (match_w e (phi e)))))
(assert (known h))
(assert (leads_kw h))
(check-sat)
