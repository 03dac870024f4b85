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
  words = {'were samples', 'was a sample'};
  taken = [words{1 + isscalar(cases)}, ' already (results/library.csv)'];
  if ~isempty (cases) && sharesStore (Case)
    text = sprintf ('%s of %s in %s %s', countText (numel (cases), 'run'), ...
                    countText (numel (unique (cases)), 'case'), Case.store, taken);
  elseif ~isempty (cases)
    text = sprintf ('%s of earlier starts %s', countText (numel (cases), 'run'), taken);
  end
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
