% MATERIALTEXT  The values of a calibrated case as a text for another program.
%
% CALL: [TEXT, PAGE] = materialText (CASE, CALIBRATION, PROGRAM, OTHERS)
%
%   CASE         see newCase
%   CALIBRATION  decoded results/calibration.json (or best.json)
%   PROGRAM      see materialLines; or 'card' (materialCard)
%   OTHERS       1 x n cell of folders of further cases of the material, for the
%                card; 'store': those on the store with the same first remark in
%                measured.csv
%   TEXT         lines, with what the values are worth in front; of a card its JSON
%   PAGE         of a card its page (HTML); else ''
%
% Errors: DEcalioc:materialText:missingFile, DEcalioc:materialLines:unknownName
%
% See also: sayExport

function [text, page] = materialText (Case, calibration, program, others)
  list = materialValues (Case, calibration);
  page = '';
  if strcmp (program, 'card')
    card = materialCard (list, withOthers (Case, calibration, others));
    text = [jsonencode(card), "\n"];
    page = cardPage (Case.root, card);
    return
  end
  lines = materialLines (program, list);
  if isempty (lines)
    lines = "# Your script has names of its own: set these values in it.\n";
  end
  text = [remarks(calibration, list), lines];
end

% What the values are worth, in front of them.
function text = remarks (c, list)
  lines = {resultTitle(c, c.date)};
  for one = list(strcmp ({list.from}, 'calibrated'))
    known = 'no interval';
    if all (isfinite (one.interval))
      known = sprintf ('90 %%: %.4g to %.4g', one.interval);
    end
    lines{end + 1} = sprintf ('%s %.6g (%s)', one.name, one.value, known);
  end
  lines = strcat ({'# '}, lines);
  text = strjoin ([lines, {''}], "\n");
end

% Of other cases their files are read, none of their programs is called: who shares a
% store need not be trusted.
function results = withOthers (Case, calibration, others)
  own = canonicalize_file_name (Case.folder);
  results = resultOf (Case.folder, calibration);
  isAll = strcmp (others, 'store');
  places = cellfun (@canonicalize_file_name, others(~isAll), 'UniformOutput', false);
  if any (isAll)
    [origins, marks] = casesOf (Case);
    same = cellfun (@(m) isequal (m(1:min (end, 1)), ...
                                  results.remarks(1:min (end, 1))), marks);
    places = [places, origins(same)];
  end
  for place = setdiff (places(cellfun (@ischar, places)), own)
    c = readJsonFile (fullfile (place{1}, 'results', 'calibration.json'));
    if isstruct (givenField (c, 'params', []))
      results(end + 1) = resultOf (place{1}, c);
    elseif any (strcmp (place{1}, others))
      error ('DEcalioc:materialText:missingFile', ...
             '%s holds no results/calibration.json. Calibrate it first.', place{1});
    end
  end
end

function r = resultOf (folder, calibration)
  [~, base, ending] = fileparts (folder);
  r = struct ('name', [base, ending], 'remarks', {measuredRemarks(folder)}, ...
              'calibration', calibration);
end

function [places, remarks] = casesOf (Case)
  names = cell (1, 0);
  for model = Case.models
    kinds = readLibrary (runPlace (Case, model.name));
    names = [names, {kinds.origin}];
  end
  places = cell (1, 0);
  for name = unique (names)
    place = canonicalize_file_name (name{1});
    if ischar (place) && isfolder (place)
      places{end + 1} = place;
    end
  end
  places = unique (places);
  remarks = cellfun (@measuredRemarks, places, 'UniformOutput', false);
end

%!test
%! Case = readyCase ();
%! c = struct ('params', struct ('a', 3, 'b', 4), 'interval90', ...
%!             struct ('a', [2, 4], 'b', []), 'converged', true, 'reason', 'met', ...
%!             'date', '2026-01-01', 'version', '1');
%! [text, page] = materialText (Case, c, 'table', {});
%! assert (isempty (page));
%! assert (~isempty (strfind (text, 'a 3 (90 %: 2 to 4)')), text);
%!error id=DEcalioc:materialText:missingFile
%! Case = readyCase ();
%! materialText (Case, struct ('params', struct ('a', 1)), 'card', {emptyFolder()});

% SPDX-License-Identifier: GPL-3.0-only
