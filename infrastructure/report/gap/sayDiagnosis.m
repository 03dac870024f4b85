% SAYDIAGNOSIS  Tells a plant engineer what the diagnosis has found.
%
% CALL: sayDiagnosis (DIAGNOSIS, CASE, SAY)
%
%   DIAGNOSIS  of diagnoseMatrices, with its field verdict (decideCase)
%   CASE       struct with the field folder
%   SAY        function handle that takes one line of text
%
% Four plain lines first: where, what, how much is closed, to do. Then tables.

function sayDiagnosis (diagnosis, Case, say)
  sayPlain (diagnosis.verdict, say);
  sayWhere (diagnosis, say);
  if isfile (fullfile (Case.folder, 'results', 'calibration.json'))
    say (['  ', whyTwoSets()]);
  end
  sayWhich (diagnosis, say);
  if ~isempty (diagnosis.verdict.cause.closed)
    sayHowFar (diagnosis.howFar, diagnosis.gapProblem, say);
  end
  if isfield (diagnosis, 'level') && ~isempty (diagnosis.level)
    say ('');
    say (['LEVEL: ', levelText(diagnosis.level)]);
  end
  sayConditions (diagnosis.others, say);
  say ('');
  sayNext (diagnosis, say);
  say ('');
  say (sprintf ('DEM runs: %d new, %d failed, %.1f core-minutes', ...
                diagnosis.budget.new, diagnosis.budget.failed, ...
                diagnosis.budget.coreSeconds / 60));
  say (['Details: ', fullfile(Case.folder, 'gap', 'gap.json'), ...
        ' and the tables beside it']);
end

% Where no test of the case would tell, what is known of the family.
function sayNext (diagnosis, say)
  say (['NEXT TEST: what would tell most about the kind of cause (1: as ', ...
        'much as a sure yes or no)']);
  for t = diagnosis.next(1:min (3, numel (diagnosis.next)))(:)'
    say (sprintf ('  %-50s %.2f', t.test, t.gain));
  end
  if ~any ([diagnosis.next.gain] >= 0.2)
    say (['  None tells 0.2. ', tellApart(diagnosis.which.effects)]);
  end
end

% Where more than one condition is laid beside the reference.
function sayConditions (others, say)
  if numel (others.conditions) < 2
    return
  end
  say ('');
  say ('CONDITIONS, beside the reference:');
  for one = others.conditions
    say (sprintf ('  %-20s %s  %s', one.name, one.verdict, ...
                  strjoin (one.effects, ', ')));
  end
  for one = others.order
    say (sprintf ('  more %s in %s than in %s, probability %.2f', ...
                  one.effect, one.more, one.less, one.probability));
  end
end

function sayPlain (v, say)
  cause = v.cause;
  say ('');
  say (['MISSES  ', cause.where]);
  say (['CAUSE   ', cause.sentence]);
  if ~isempty (cause.closed)
    say (['CLOSED  ', cause.closed]);
  end
  say (['NEXT    ', v.action]);
  if ~isempty (cause.cannotSee)
    say (['        Cannot be seen here, so neither found nor excluded: ', ...
          strjoin(cause.cannotSee, ', ')]);
  end
end

function sayWhere (diagnosis, say)
  where = diagnosis.where;
  gapProblem = diagnosis.gapProblem;
  say ('');
  model = 'model';
  text = ['WHERE: noise alone would make the calibrated model miss the %d ' ...
          'measurements by as much with p = %.3g'];
  if ~isempty (gapProblem.reference)
    model = 'foretold';
    text = strrep (text, 'the calibrated model miss the %d', ...
                   ['the reference miss the %d new']);
  end
  say (sprintf (text, numel (gapProblem.used), where.p));
  say (sprintf ('  %-28s %11s %11s %7s %7s  %s', 'target', 'measured', ...
                model, 'z', 'p', ''));
  for i = 1:numel (gapProblem.used)
    t = gapProblem.used(i);
    mark = '';
    if where.pTarget(i) < 0.05
      mark = '<-- off';
    elseif where.blind(i)
      mark = 'blind: parameters can hide an error here';
    end
    say (sprintf ('  %-28s %11.5g %11.5g %7.1f %7.3f  %s', ...
                  gapProblem.targetNames{t}, gapProblem.value(t), ...
                  gapProblem.value(t) - where.residual(i), where.t(i), ...
                  where.pTarget(i), mark));
  end
  for i = 1:numel (gapProblem.heldOut)
    t = gapProblem.heldOut(i);
    mark = 'held out';
    if where.held.p(i) < 0.05
      mark = '<-- off, held out';
    end
    say (sprintf ('  %-28s %11.5g %11.5g %7.1f %7.3f  %s', ...
                  gapProblem.targetNames{t}, gapProblem.value(t), ...
                  where.held.mean(i), where.held.z(i), where.held.p(i), mark));
  end
  say (['  z: miss in units of all noise; p: how often noise alone makes ', ...
        'one of the fitted (or held-out) ones as odd']);
  [~, order] = sort (-[where.benches.size]);
  for b = where.benches(order)
    say (sprintf ('  bench %-22s p = %.3f, off by %.1f sd', ...
                  gapProblem.benchNames{b.bench}, b.p, b.size));
  end
  why = {'none of its runs gave a result', 'it was never run to its end'};
  for b = where.out(:)'
    isNever = any (strcmp (b{1}, where.neverRun));
    say (sprintf ('  %s is out, for %s', b{1}, why{1 + isNever}));
  end
  if ~isempty (where.conflict.odd)
    say (sprintf ('  %s disagrees with all other benches', ...
                  gapProblem.benchNames{where.conflict.odd}));
  end
  if ~isempty (where.side.atLimit)
    say (['  at the limit of their range: ', ...
          strjoin(where.side.atLimit, ', ')]);
  end
end

function sayWhich (diagnosis, say)
  w = diagnosis.which;
  say ('');
  say (['WHICH: ', diagnosis.verdict.cause.word]);
  if ~isempty (w.partners)
    say (['  together with one of: ', strjoin(w.partners, ', ')]);
  end
  [~, order] = sort (-diagnosis.screen.gain);
  say (sprintf ('  %-20s %11s  %s', 'effect', 'probability', ...
                'how strong it would be (90 % interval)'));
  null = 'no gap';
  if ~isempty (diagnosis.gapProblem.reference)
    null = 'nothing changed';
  end
  say (sprintf ('  %-20s %11.3f', null, w.posterior.null));
  for k = order
    s = w.strength(k);
    p = w.posterior.(matlab.lang.makeValidName (s.name));
    say (sprintf ('  %-20s %11.3f  %s', s.name, p, ...
                  strengthText (s, diagnosis.screen.smallest(k), ...
                                diagnosis.gapProblem)));
  end
  say (sprintf ('  %-20s %11.3f', 'none of the listed', ...
                w.posterior.unlisted));
  sayResembling (w, say);
  e = w.expected;
  if isfinite (e.top1)
    say (sprintf (['  On %d data sets of the same design with a known ' ...
                   'cause:'], e.n));
    sayShare ('the likeliest effect is right', e.top1, say);
    sayShare ('a name is right', e.precision, say);
    sayShare ('without a gap a name is given', e.falseName, say);
    sayShare ('with the cause missing from the list one is given', ...
              e.wrongUnlisted, say);
  end
end

function text = strengthText (s, smallest, gapProblem)
  text = 'cannot be seen';
  if isinf (smallest) || isempty (s.values)
    return
  end
  e = gapProblem.effects(strcmp ({gapProblem.effects.name}, s.name));
  if isfield (e, 'label') && columns (s.values) == 1
    text = effectText (e.label, e.unit, s.values);
  else
    text = sprintf ('%.2f of its range (%.2f to %.2f)', s.value, s.interval90);
  end
end

% Of what is not listed, the part that resembles a listed effect.
function sayResembling (w, say)
  names = fieldnames (w.resembles);
  for k = 1:numel (names)
    if w.resembles.(names{k}) > 0.02
      say (sprintf ('    resembling %-9s %9.3f', names{k}, ...
                    w.resembles.(names{k})));
    end
  end
end

function sayShare (what, share, say)
  if isfinite (share)
    say (sprintf ('    %s in %.0f %%', what, 100 * share));
  end
end

%!test
%! [~, text] = situationPage ('missed, named');
%! assert (! isempty (strfind (text, ...
%!         'CAUSE   Missing in the model: cohesion 41 kJ/m3')));
%! assert (! isempty (strfind (text, ...
%!         '7        6.65     3.5   0.010  <-- off')));
%! assert (! isempty (strfind (text, 'WHICH: Cause found: cohesion')), text);
%!test
%! % where no gap is told, nothing is said of how far it is closed
%! list = verdictCase ();
%! s = list(strcmp ({list.name}, 'missed, no gap'));
%! s.gap.howFar.effect = 'cohesion';
%! raw = standInCase (tempname ());
%! text = verdictConsole (s, newCase (raw));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
%! assert (! isempty (strfind (text, 'WHICH: No gap seen')));
%! assert (isempty (strfind (text, 'HOW FAR')));
