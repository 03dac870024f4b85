% The run of a packing was taken out of use; the run that had started from it still
% counted, and the packing that the message promised was never made.

%!function [c, out] = calibrated (folder)
%!  [status, out] = startCommand (folder, 'run');
%!  assert (any (status == [0, 2]), '%s', out);
%!  c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%!endfunction

%!test
%! folder = reportedCase ('forgottenUpstream');
%! calibrated (folder);
%! runs = @(model) glob (fullfile (folder, 'optim', model, '[0-9]*'));
%! before = [numel(runs ('Fill')), numel(runs ('Tap'))];
%! [status, out] = startCommand (folder, 'forget . Fill 3');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, '1 run of Fill, and 1 run of Tap that')), out);
%! from = cellfun (@readlink, fullfile (runs ('Tap'), 'Fill'), 'UniformOutput', false);
%! tap = runs ('Tap'){strcmp(from, '../../Fill/0003')};
%! record = @(f) readRecord (fullfile (f, 'record.json'));
%! assert (record (tap).status, 'forgotten');
%! % another packing, and a run that starts from it
%! calibrated (folder);
%! assert ([numel(runs ('Fill')), numel(runs ('Tap'))] >= before + 1);
%! sets = @(m) cellfun (@(f) record (f).seed, runs (m));
%! same = cellfun (@(f) isequal (record (f).params, record (tap).params), runs ('Tap'));
%! seeds = sets ('Tap')(same);
%! assert (numel (unique (seeds)) >= 2);
%! assert (all (ismember (seeds, sets ('Fill'))));
%! % and back, with what started there
%! [~, out] = startCommand (folder, 'forget . Fill 3 --back');
%! assert (record (tap).status, 'ok');
%! assert (! isempty (strfind (out, '1 run of Tap')), out);

%!test
%! % a stage of a stage
%! folder = reportedCase ('forgottenUpstream');
%! model = @(name, varargin) fullfile (folder, 'DEMmodels', name, varargin{:});
%! mkdir (model ('Rest'));
%! copyfile (model ('Fill', '*'), model ('Rest'));
%! writeAtomic (model ('Rest', 'startsFrom'), "Fill\n");
%! writeAtomic (model ('Tap', 'startsFrom'), "Rest\n");
%! writeAtomic (model ('Tap', 'runscript'), ...
%!              strrep (fileread (model ('Tap', 'runscript')), 'Fill/', 'Rest/'));
%! calibrated (folder);
%! [status, out] = startCommand (folder, 'forget . Fill 2');
%! assert (status == 0 && ! isempty (strfind (out, '1 run of Rest, 1 run of Tap')), out);

% SPDX-License-Identifier: GPL-3.0-only
