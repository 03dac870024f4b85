% PAGESECTIONS  The parts of the report, in their order.
%
% CALL: SECTIONS = pageSections ()
%
%   SECTIONS  cell of handles of functions [TITLE, HTML] = section (PAGE), PAGE
%             see pageData; HTML is '' where a case has nothing to show there
%
% See also: writePage

function sections = pageSections ()
  sections = {@sectionTargets, @sectionWhich, @sectionParameters, ...
              @sectionParticles, @sectionWhere, @sectionHowFar, ...
              @sectionNextTest, @sectionPlan, @sectionSlices, ...
              @sectionLeaveOneOut, @sectionSteps, @sectionSensitivity, ...
              @sectionRuns, @sectionSettings};
end

%!test
%! % each is there, and says nothing of a case without any file
%! Case = newCase (standInCase (tempname ()));
%! page = pageData (Case);
%! for section = pageSections ()
%!   [title, html] = section{1} (page);
%!   assert (ischar (title) && ! isempty (title));
%!   assert (ischar (html));
%! end
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
