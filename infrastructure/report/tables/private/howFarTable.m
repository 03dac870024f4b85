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
  at = @(varargin) [{'gap', 'howFar'}, varargin];
  own = @(data, varargin) {plainName(effect), data, at(varargin{:}, 'before'), ...
                           at(varargin{:}, 'after'), at(varargin{:}, 'floor'), ...
                           at(varargin{:}, 'closure'), at(varargin{:}, 'interval90'), ''};
  named = @(k) plainName (jsonAt (far, {'placebos', k, 'effect'}));
  other = @(k, data, field, text) {[named(k), ' instead'], data, NaN, NaN, NaN, ...
                                   at('placebos', k, field), NaN, text};
  many = 1 + isstruct (jsonAt (far, {'heldOut'}));     % rows of a cause
  rows_ = {own('fitted'), own('not fitted', 'heldOut')};
  rows_ = rows_(1:many);
  for k = 1:numel (jsonAt (far, {'placebos'}))
    both = {other(k, 'fitted', 'closure', ''), ...
            other(k, 'not fitted', 'heldOut', favours (far, jsonAt (far, {'placebos', k})))};
    rows_ = [rows_, both(1:many)];
  end
  titles = {'How much of the gap is closed, ', 'How much of the change is explained, '};
  T = newTable (page, 'howfar', [titles{1 + page.isChange}, judgedHow(far)], ...
                {'with', '', ''; 'data', '', ''; 'before', '', 'percent'; ...
                 'after', '', 'percent'; 'noise alone', '', 'percent'; ...
                 'closed', '', 'percent'; '90 % interval', '', 'percent'; ...
                 'remark', '', 'words'}, rows_, {sentence('table.howFar')});
  row = @(k) {targetCell(page, jsonAt (far, {'targets', k})), at('targets', k, 'measured'), ...
              at('targets', k, 'before'), at('targets', k, 'after'), ...
              noiseOf(far, k, at('targets', k, 'sd'))};
  each = newTable (page, 'beforeafter', 'Each result without and with the cause', ...
                   {'result', '', 'name'; 'measured', '', 'plain'; ...
                    'without', '', 'plain'; 'with', '', 'plain'; ...
                    'noise after the fit (sd)', '', 'error'}, ...
                   eachOf (row, 1:numel (jsonAt (far, {'targets'}))));
end

% Where the fit has as many unknowns as data, nothing is left to estimate a noise.
function steps = noiseOf (far, k, steps)
  T = jsonAt (far, {'targets', k});
  if ~(abs (T.sd) > 1e-6 * abs (T.measured))
    steps = NaN;
  end
end

% How much more likely the cause makes test data that were not fitted: said where
% it closes something of them.
function text = favours (far, placebo)
  text = '';
  ratio = jsonAt (placebo, {'logRatio'});
  if isempty (ratio) || ~any (jsonAt (far, {'heldOut', 'closure'}) > 0.005)
    return
  end
  names = plainName ({far.effect, placebo.effect});
  if ratio < 0
    names = fliplr (names);
  end
  values = struct ('cause', names{1}, 'other', names{2}, ...
                   'times', sprintf ('%.3g', exp (abs (ratio))));
  if abs (ratio) > log (1000)           % beyond it the shape of noise decides
    values.times = 'more than 1000';
  end
  text = sentence ('table.favours', values);
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
%! page.sources.gap.howFar.placebos.effect = 'wallAdhesion';
%! T = howFarTable (page);
%! assert (T.cells{4, 1}.value, 'wall adhesion instead');
%! assert (! isempty (strfind (T.cells{4, 8}.value, 'over wall adhesion')), T.cells{4, 8}.value);
%! page.sources.gap.howFar.heldOut.closure = 0.001;
%! assert (howFarTable (page).cells{4, 8}.value, '');

% SPDX-License-Identifier: GPL-3.0-only
