% BLINDTABLE  Writes the answers to a sealed study as two small tables.
%
% CALL: blindTable (STEM, NUMBERS, ANSWERS, CODE)
%
%   STEM     path without ending: STEM-answers.csv gets a line per case,
%            STEM-strengths.csv a line per case and effect
%   NUMBERS  1 x n, cases;  ANSWERS  1 x n cell of blindAnswer
%   CODE     text, commit of the code that answered
%
% See also: blindAnswer, blindScore

function blindTable (stem, numbers, answers, code)
  lines = {['case,verdict,effects,lookAlike,guard,gateP,pNull,pUnlisted,' ...
            'top,pTop,benches,targets,cure,closure,closureLo,closureHi,' ...
            'held,heldLo,heldHi,placebo,sets,code']};
  strengths = {'case,effect,p,resembles,value,lo90,hi90'};
  for i = 1:numel (answers)
    if isempty (answers{i})
      lines{end + 1} = sprintf ('%d,no answer%s', numbers(i), ...
                                repmat (',', 1, 20));
      continue
    end
    d = jsondecode (answers{i});
    lines{end + 1} = [sprintf('%d,', numbers(i)), ofVerdict(d.which), ',', ...
                      ofPlaces(d.where), ',', ofClosure(d.howFar), ...
                      sprintf(',%d,%s', d.demRuns.sets, code)];
    strengths = [strengths, ofStrengths(numbers(i), d.which)];
  end
  writeTable ([stem, '-answers.csv'], lines);
  writeTable ([stem, '-strengths.csv'], strengths);
end

function text = ofVerdict (verdict)
  names = setdiff (fieldnames (verdict.posterior), {'null', 'unlisted'})';
  total = cellfun (@(n) verdict.posterior.(n), names);
  [p, likeliest] = max (total);
  text = sprintf ('%s,%s,%d,%s,%.4g,%.4g,%.4g,%s,%.4g', verdict.verdict, ...
                  strjoin (cellstr (verdict.effects)(:)', ' '), ...
                  verdict.lookAlike, verdict.guard, verdict.p, ...
                  verdict.posterior.null, ...
                  verdict.posterior.unlisted, names{likeliest}, p);
end

% Benches and targets, worst first; names as in the campaign.
function text = ofPlaces (place)
  used = place.targets(strcmp ({place.targets.role}, 'calibrate'));
  names = strrep ({used.name}, 'Collapse_slope', 'collapseSlope');
  names = strrep (names, 'Heap_slope', 'heapSlope');
  names = strrep (names, 'Drum_slope', 'drumSlope');
  names = strrep (names, 'SlotBin_slope', 'binSlope');
  names = strrep (names, 'slope3', 'drumSlope3');
  [benches, targets] = blindPlaces ({place.models.model}, ...
                                    [place.models.size], names, [used.size]);
  text = [benches, ',', targets];
end

function text = ofClosure (far)
  if isempty (far) || ~isfield (far, 'closure')
    text = repmat (',', 1, 7);
    return
  end
  placebo = NaN;
  for one = far.placebos(:)'
    placebo = max ([placebo, orNaN(one.closure)]);
  end
  held = far.heldOut;
  if isempty (held)
    held = struct ('closure', NaN, 'interval90', []);
  end
  text = strjoin ([{far.effect}, ...
                   arrayfun(@(v) sprintf ('%.3g', v), ...
                            [orNaN(far.closure), ends(far.interval90), ...
                             orNaN(held.closure), ends(held.interval90), ...
                             placebo], 'UniformOutput', false)], ',');
end

function value = orNaN (value)
  if isempty (value)
    value = NaN;
  end
end

function two = ends (interval)
  two = interval(:)';
  if iscell (two) || numel (two) ~= 2
    two = [NaN, NaN];
  end
end

function lines = ofStrengths (number, verdict)
  lines = {};
  for name = fieldnames (verdict.strength)'
    one = verdict.strength.(name{1});
    lines{end + 1} = sprintf ('%d,%s,%.4g,0,%.4g,%.4g,%.4g', number, ...
                              name{1}, verdict.posterior.(name{1}), ...
                              orNaN (one.value), ...
                              ends (one.interval90));
  end
end

% Benches, and the four targets, by what is left after the fit (in standard
% deviations of the noise), worst first, as texts.
function [benches, targets] = blindPlaces (benchNames, ofBenches, ...
                                           targetNames, ofTargets)
  [~, order] = sort (-ofBenches);
  benches = strjoin (benchNames(order), ' ');
  [~, order] = sort (-ofTargets);
  targets = strjoin (targetNames(order(1:min (end, 4))), ' ');
end
