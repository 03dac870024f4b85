% HOWFARTABLE  Statement: how far the gap shrinks with a cause, and with others.
%
% CALL: [T, EACH] = howFarTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable: the cause, and those it was compared with; [] where none
%         was tried
%   EACH  see newTable: each result before and after

function [T, each] = howFarTable (page)
  [T, each] = deal ([]);
  far = jsonAt (page.sources.gap, {'howFar'});
  effect = jsonAt (far, {'effect'});
  if isempty (effect) || isempty (jsonAt (far, {'before'}))
    return
  end
  data = {'fitted', 'not fitted'};
  at = @(varargin) [{'gap', 'howFar'}, varargin];
  row = @(k, varargin) {effect, data{k}, at(varargin{:}, 'before'), ...
                        at(varargin{:}, 'after'), at(varargin{:}, 'floor'), ...
                        at(varargin{:}, 'closure'), at(varargin{:}, 'interval90'), ''};
  cells = row (1);
  held = jsonAt (far, {'heldOut'});
  if isstruct (held)
    cells(2, :) = row (2, 'heldOut');
  end
  for k = 1:numel (jsonAt (far, {'placebos'}))
    placebo = jsonAt (far, {'placebos', k});
    name = sprintf ('%s instead', placebo.effect);
    cells = [cells; {name, data{1}, NaN, NaN, NaN, at('placebos', k, 'closure'), NaN, ''; ...
                     name, data{2}, NaN, NaN, NaN, at('placebos', k, 'heldOut'), NaN, ...
                     favours(far, placebo)}];
  end
  how = {'closed.onSurrogates', 'closed.byDEM'};
  isVerified = isequal (jsonAt (far, {'verifiedByDEM'}), true);
  T = newTable (page, 'howfar', ['How much of the gap is closed, ', ...
                                 sentence(how{1 + isVerified})], ...
                {'with', '', ''; 'data', '', ''; 'before', '', 'percent'; ...
                 'after', '', 'percent'; 'noise alone', '', 'percent'; ...
                 'closed', '', 'percent'; '90 % interval', '', 'percent'; ...
                 'remark', '', 'words'}, cells, {sentence('table.howFar')});
  each = eachOf (page, far, at);
end

% How much more likely the cause makes test data that were not fitted: said where
% it closes something of them.
function text = favours (far, placebo)
  text = '';
  ratio = jsonAt (placebo, {'logRatio'});
  closure = jsonAt (far, {'heldOut', 'closure'});
  if isempty (ratio) || isempty (closure) || closure <= 0.005
    return
  end
  values = struct ('cause', far.effect, 'other', placebo.effect);
  if ratio < 0
    values = struct ('cause', placebo.effect, 'other', far.effect);
  end
  values.times = sprintf ('%.3g', min (exp (abs (ratio)), 1000));
  if abs (ratio) > log (1000)           % beyond it the shape of noise decides
    values.times = 'more than 1000';
  end
  text = sentence ('table.favours', values);
end

function each = eachOf (page, far, at)
  targets = jsonAt (far, {'targets'});
  n = numel (targets);
  cells = cell (n, 5);
  for k = 1:n
    cells(k, :) = {targetCell(page, jsonAt (targets, {k})), at('targets', k, 'measured'), ...
                   at('targets', k, 'before'), at('targets', k, 'after'), ...
                   at('targets', k, 'sd')};
  end
  each = newTable (page, 'beforeafter', 'Each result before and after', ...
                   {'result', '', 'name'; 'measured', '', 'plain'; ...
                    'without', '', 'plain'; 'with', '', 'plain'; ...
                    'noise (sd)', '', 'error'}, cells);
end

%!test
%! page = situationPage ('missed, named');
%! T = howFarTable (page);
%! assert (rows (T.cells), 4);
%! assert (T.cells{1, 6}.value, 0.9);
%! assert (T.cells{4, 1}.value, 'tilt instead');
%! % a cause that closes nothing is not said to be a thousand times as likely
%! page.sources.gap.howFar.placebos.logRatio = 50;
%! assert (! isempty (strfind (howFarTable (page).cells{4, 8}.value, 'more than 1000')));
%! page.sources.gap.howFar.heldOut.closure = 0.001;
%! assert (howFarTable (page).cells{4, 8}.value, '');
