% LIBRARYLINE  Which earlier runs a calibration started from, in words.
%
% CALL: TEXT = libraryLine (CASE)
%
%   CASE  see newCase: its results/library.csv is read
%   TEXT  one line; '' where there were none
%
% See also: libraryRuns, sayStatus, sectionRuns

function text = libraryLine (Case)
  [~, ~, cases] = readTaken (Case.folder);
  text = '';
  if isempty (cases)
    return
  end
  of = ' of earlier starts';
  if sharesStore (Case)
    of = [' of ', countText(numel (unique (cases)), 'case'), ' in ', Case.store];
  end
  text = [countText(numel (cases), ['run', of, ' was a sample'], ...
                    ['runs', of, ' were samples']), ' already (results/library.csv)'];
end

%!test
%! Case = struct ('folder', tempname (), 'store', '/s');
%! mkdir (fullfile (Case.folder, 'results'));
%! assert (libraryLine (Case), '');
%! writeAtomic (fullfile (Case.folder, 'results', 'library.csv'), ...
%!              "# abc\nnumber,run,model,case\n1,7,M,/a\n1,8,M,/b\n");
%! assert (strncmp (libraryLine (Case), '2 runs of 2 cases in /s', 23));
%! Case.store = Case.folder;
%! assert (strncmp (libraryLine (Case), '2 runs of earlier starts', 24));

% SPDX-License-Identifier: GPL-3.0-only
